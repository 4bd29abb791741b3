#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/output_folder.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/drive.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/locked_friction.h"
#include "identify/command_line/output_file.h"
#include "identify/command_line/print.h"
#include "identify/command_line/results_line.h"
#include "identify/command_line/solve_history.h"
#include "identify/inspection/file_kind.h"
#include "identify/report/simulated_motion.h"
#include "identify/report/simulation_page.h"
#include "identify/run/result_kind.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/requests/chosen_sensors.h"
#include "vehicles/requests/engine_text.h"
#include "vehicles/requests/history_chart.h"
#include "vehicles/requests/history_files.h"
#include "vehicles/requests/parameter_setting.h"
#include "vehicles/simulation/sensor_model.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;

using HistoryWriter = std::string (*)(const std::string& motion, const TimeHistory& history,
                                      const std::vector<HistoryChannel>& channels);

/// By the ending of a file; null for one that is not known.
HistoryWriter WriterOf(const fs::path& file) {
  static const std::map<std::string, HistoryWriter> writers = {
      {".csv", [](const auto&, const auto& history, const auto& channels) { return HistoryCsv(history, channels); }},
      {".uff", &HistoryUniversal},
      {".rsp", &HistoryRpc},
      {".drv", &HistoryDrive}};
  const auto found = writers.find(file.extension().string());
  return found == writers.end() ? nullptr : found->second;
}

/// What was read, without a fault.
struct HistoryJob {
  Vehicle vehicle;
  std::vector<std::size_t> sensors;
  Drive drive;
  Diagnostics findings;
};

HistoryJob ReadJob(const SimulateCommand& command) {
  RequireVehicleFile(command.model);
  Diagnostics findings = command.faults;
  std::optional<Vehicle> vehicle = ReadVehicle(command.model, findings);
  if (!vehicle) throw FaultyInput(findings);
  SetParameters(command.set, *vehicle, findings);
  std::vector<std::size_t> sensors = ChosenSensors(command.channels, *vehicle, findings);
  CheckMotion(command, *vehicle, findings);
  if (findings.HasErrors()) throw FaultyInput(findings);
  Drive drive = DriveOf(command, *vehicle, findings);
  return {std::move(*vehicle), std::move(sensors), std::move(drive), std::move(findings)};
}

/// A folder has no ending.
bool WritesFolder(const SimulateCommand& command) {
  return !command.output.empty() && command.output.extension().empty();
}

void CheckOutputs(const SimulateCommand& command) {
  if (!command.output.empty() && command.output == command.chart) RefuseToWrite(kOutputNamedTwice, command.output);
  RequireWritable(command.chart, {command.model, command.recording});
  RequireEnding("--chart", command.chart, "a picture", ".svg");
  if (WritesFolder(command)) {
    std::vector<fs::path> inputs = {command.model};
    if (!command.recording.empty()) inputs.push_back(command.recording);
    RequireInputsElsewhere(inputs, command.output);
    RequireNoOtherResult(command.output, ResultKind::kSimulation);
    OutputFolder{command.output};
    return;
  }
  RequireWritable(command.output, {command.model, command.recording});
  if (!command.output.empty() && WriterOf(command.output) == nullptr)
    Refuse(kOutputEnding, Place::Option("--output"),
           {command.output.string(), "a time history", ".csv, .uff, .rsp or .drv, or to a folder without an ending",
            fs::path(command.output).replace_extension(".csv").string()});
}

/// As the rig's acquisition has it; the filter settles during the lead, which goes then.
void Record(const SimulateCommand& command, const Drive& drive, TimeHistory& history) {
  if (command.filter_Hz) {
    const SensorModel filter{.filter = SensorModel::Filter{command.filter_order, *command.filter_Hz}};
    filter.Apply(history);
  }
  history.DropFirst(TimeGrid{drive.start_s, drive.end_s, command.rate_Hz, drive.lead_s}.lead_count());
  SensorModel{.noise = command.noise, .seed = command.seed}.Apply(history);
}

HistoryOrigin OriginOf(const SimulateCommand& command, const Drive& drive, const SolvedHistory& answer) {
  return {
      .motion = drive.name, .by = answer.by, .seed = command.seed, .error = command.error, .interrupted = answer.ended};
}

std::string Text(const HistoryOrigin& origin, const std::vector<HistoryChannel>& channels) {
  TextTable table({"channel", "unit", "mean", "rms", "peak", "peak to peak"});
  for (const HistoryChannel& channel : channels) {
    const Extent extent = ExtentOf(channel.values);
    table.Add({channel.name, channel.unit, Rounded(extent.mean, 4), Rounded(extent.rms, 4), Rounded(extent.peak, 4),
               Rounded(extent.peak_to_peak, 4)});
  }
  return origin.motion + '\n' + table.Format() + EngineText(origin.by);
}

void FindWhatIsOdd(const HistoryJob& job, const HistoryOrigin& origin, const AnsweredHistory& solved,
                   Diagnostics& findings) {
  WarnOfLocked(job.vehicle, solved.locked, "this motion", findings);
  WarnOfPulls(job.vehicle, solved.pulls, "samples", "this motion", findings);
  const Place error = Place::Option("--error");
  if (origin.by.change && *origin.by.change > origin.error) {
    const std::string change = Percent(*origin.by.change, 3);
    if (origin.by.step_s)
      findings.Report(kStepNotConverged, error, {Rounded(1e6 * *origin.by.step_s, 3) + " us", change});
    else findings.Report(kIntegratorNotConverged, error, {change});
  }
  if (!origin.by.not_estimated.empty())
    findings.Report(kLinearKinematicsUnknown, Place::Option("--engine"), {origin.by.not_estimated});
}

std::string ChartOf(const HistoryJob& job, const HistoryOrigin& origin, const TimeHistory& history,
                    const std::vector<HistoryChannel>& channels) {
  return HistorySvg("Time history of " + job.vehicle.name, origin.motion, history.start_s, history.rate_Hz, channels);
}

/// The full system moves where the reduced one does not: its page has no moving vehicle.
HistoryMotion MotionOf(const HistoryJob& job, const TimeHistory& history) {
  try {
    return SimulatedMotion(job.vehicle, job.drive.motion,
                           {history.start_s, history.TimeAt(history.size() - 1), 0, job.drive.lead_s},
                           job.drive.upper_Hz);
  } catch (const std::runtime_error&) {
    return {};
  }
}

void Write(const SimulateCommand& command, const HistoryJob& job, const HistoryOrigin& origin,
           const TimeHistory& history, const std::vector<HistoryChannel>& channels) {
  const SimulationAnswer shown{.origin = origin,
                               .start_s = history.start_s,
                               .rate_Hz = history.rate_Hz,
                               .channels = channels,
                               .motion = MotionOf(job, history),
                               .findings = job.findings};
  OutputFolder output(command.output);
  output.Add("history.csv", HistoryCsv(history, channels));
  output.Add("history.svg", ChartOf(job, origin, history, channels));
  output.Add(kPageName, SimulationPage(job.vehicle, shown));
  output.Add("result.json", HistoryJson(job.vehicle, origin, history, channels, job.findings));
  output.Commit();
  PrintResultsLine(command.output);
}

/// Two samples make a history.
bool HasHistory(const SimulateCommand& command, const Drive& drive, const TimeHistory& history) {
  return history.size() >= TimeGrid{drive.start_s, drive.end_s, command.rate_Hz, drive.lead_s}.lead_count() + 2;
}

}  // namespace

int Run(const SimulateCommand& command) {
  CheckOutputs(command);
  HistoryJob job = ReadJob(command);
  Tell(job.findings);
  CatchInterrupts();
  Diagnostics found;
  AnsweredHistory solved = SolveHistory(command, job.vehicle, job.drive, found);
  TimeHistory& history = solved.answer.history;
  if (!HasHistory(command, job.drive, history)) {
    Tell(kInterruptedAtStart);
    return kInterrupted;
  }
  Record(command, job.drive, history);
  const HistoryOrigin origin = OriginOf(command, job.drive, solved.answer);
  FindWhatIsOdd(job, origin, solved, found);
  Tell(found);
  for (const Diagnostic& item : found.items()) job.findings.Add(item);
  if (solved.answer.ended)
    Tell(kHistoryInterrupted, {},
         {Rounded(history.TimeAt(history.size() - 1), 3) + " s", Rounded(job.drive.end_s, 3) + " s"});
  const std::vector<HistoryChannel> channels = ChannelsOf(job.vehicle, history, job.sensors);
  if (WritesFolder(command)) Write(command, job, origin, history, channels);
  else if (!command.output.empty())
    WriteFile(command.output, WriterOf(command.output)(origin.motion, history, channels));
  if (!command.chart.empty()) WriteFile(command.chart, ChartOf(job, origin, history, channels));
  if (command.json) Print(HistoryJson(job.vehicle, origin, history, channels, job.findings));
  else if (command.output.empty()) Print(HistoryCsv(history, channels));
  else PrintText(Text(origin, channels));
  return solved.answer.ended ? kInterrupted : kGood;
}

}  // namespace fourpost
