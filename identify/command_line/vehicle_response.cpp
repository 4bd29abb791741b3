#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "analysis/output_folder.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/inputs_elsewhere.h"
#include "identify/command_line/print.h"
#include "identify/command_line/progress_line.h"
#include "identify/command_line/responses.h"
#include "identify/command_line/solve_sweep.h"
#include "identify/command_line/text_table.h"
#include "identify/parameter_setting.h"
#include "identify/sweep.h"
#include "identify/sweep_files.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/response/friction_lock.h"

namespace fourpost {
namespace {

/// What was read, without a fault.
struct Job {
  Vehicle vehicle;
  SweepRequest request;
  Diagnostics findings;
};

Job ReadJob(const ResponseCommand& command) {
  Diagnostics findings;
  std::optional<Vehicle> vehicle = ReadVehicle(command.input, findings);
  if (!vehicle) throw FaultyInput(findings);
  for (const std::string& text : command.set) SetParameter(text, "--set", *vehicle, findings);
  std::optional<SweepRequest> request = ReadSweep(command.sweep, *vehicle, findings);
  if (findings.HasErrors() || !request) throw FaultyInput(findings);
  return {std::move(*vehicle), std::move(*request), std::move(findings)};
}

SteadySolver MakeSolver(const Vehicle& vehicle) {
  try {
    return SteadySolver(vehicle);
  } catch (const std::invalid_argument& fault) {
    // The file's own values have been checked against each other.
    Diagnostics faults;
    faults.Error("--set", 0, std::string("these values do not go together: ") + fault.what());
    throw FaultyInput(faults);
  }
}

void FindLocked(const Vehicle& vehicle, const Sweep& sweep, Diagnostics& findings) {
  for (const LockedFriction& lock : FindLockedFriction(vehicle, sweep.excitation)) {
    const Damper& damper = vehicle.dampers[lock.damper];
    findings.Warning(vehicle.file, damper.source_line,
                     "fp:damper '" + damper.name + "' never slides in " + sweep.mode + ": its friction of " +
                         Rounded(lock.friction_N, 3) + " N holds, and its rates count for nothing; it takes about " +
                         Rounded(lock.factor, 2) + " times the motion, near " + Rounded(lock.frequency_Hz, 2) + " Hz");
  }
}

/// Gains are per metre of the post, those of displacements and accelerations plain ratios.
std::string GainUnit(const std::string& unit) { return unit == "m" || unit == "m/s^2" ? "1" : unit + "/m"; }

/// The sweep's frequencies next to those that a rig's report shows.
std::vector<std::size_t> ShownFrequencies(const std::vector<double>& frequency_Hz) {
  std::vector<std::size_t> shown;
  for (const double wanted : {0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0}) {
    const auto nearest = std::min_element(frequency_Hz.begin(), frequency_Hz.end(), [&](double a, double b) {
      return std::abs(std::log(a / wanted)) < std::abs(std::log(b / wanted));
    });
    const auto index = static_cast<std::size_t>(nearest - frequency_Hz.begin());
    if (shown.empty() || index > shown.back()) shown.push_back(index);
  }
  return shown;
}

std::vector<std::string> ChannelRow(const ChannelResponse& channel, const std::vector<double>& frequency_Hz) {
  std::size_t peak = channel.response.size();
  for (std::size_t i = 0; i < channel.response.size(); ++i)
    if (std::isfinite(std::abs(channel.response[i])) &&
        (peak == channel.response.size() || std::abs(channel.response[i]) > std::abs(channel.response[peak])))
      peak = i;
  const bool any = peak < channel.response.size();
  std::vector<std::string> row = {channel.name, GainUnit(channel.unit),
                                  any ? Rounded(std::abs(channel.response[peak]), 4) : "-",
                                  any ? Rounded(frequency_Hz[peak], 3) : "-"};
  for (const std::size_t i : ShownFrequencies(frequency_Hz)) row.push_back(Rounded(std::abs(channel.response[i]), 3));
  return row;
}

std::string GainTable(const SweptResponse& swept) {
  std::vector<std::string> head = {"gain", "unit", "peak", "at Hz"};
  for (const std::size_t i : ShownFrequencies(swept.excitation.frequency_Hz))
    head.push_back(Rounded(swept.excitation.frequency_Hz[i], 3) + " Hz");
  TextTable table(head);
  for (const ChannelResponse& channel : swept.answer.response.channels)
    table.Add(ChannelRow(channel, swept.excitation.frequency_Hz));
  return table.Format();
}

std::string Where(const LargestDifference& difference) {
  return difference.channel.empty() ? ""
                                    : " (" + difference.channel + ", " + Rounded(difference.frequency_Hz, 3) + " Hz)";
}

/// Rounded up.
std::string AtMost(double value, int decimals) {
  const double step = std::pow(10, -decimals);
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, std::max(1.0, std::ceil(value / step)) * step);
  return text;
}

/// What linear kinematics leave out, and what follows from it.
std::string Kinematics(const SteadyResponse& answer) {
  if (!answer.not_estimated.empty())
    return "what linear kinematics leave out could not be estimated: " + answer.not_estimated + "\n";
  if (!answer.kinematics_error) return "";
  const KinematicsError& error = *answer.kinematics_error;
  return "linear kinematics are off by at most " + AtMost(error.gain_dB.value, 3) + " dB" + Where(error.gain_dB) +
         " and " + AtMost(error.phase_deg.value, 2) + " deg" + Where(error.phase_deg) +
         (error.IsVisible() ? ":\nthat shows (" : ":\nless than shows (") + Rounded(KinematicsError::kVisible_dB, 1) +
         " dB, " + Rounded(KinematicsError::kVisible_deg, 1) + " deg), so " +
         (error.IsVisible() ? "the full geometry answers\n" : "they answer\n");
}

std::string Limits(const AmplitudeLaw& law) {
  std::string text;
  const auto add = [&](double value, double scale, const char* unit) {
    if (std::isfinite(value)) text += (text.empty() ? "" : ", ") + Rounded(value * scale, 3) + " " + unit;
  };
  add(law.displacement_m, 1e3, "mm");
  add(law.velocity_mps, 1, "m/s");
  add(law.acceleration_mps2, 1, "m/s^2");
  return text;
}

std::string Heading(const SweptResponse& swept, const SweepRequest& request) {
  const std::vector<double>& frequency = swept.excitation.frequency_Hz;
  return swept.mode + ": " + std::to_string(frequency.size()) + " frequencies from " + Rounded(frequency.front(), 3) +
         " to " + Rounded(frequency.back(), 3) + " Hz, swept " + (request.falling ? "down" : "up") + ", engine " +
         EngineName(swept.answer.engine) + "\nthe reference post moves at most " + Limits(request.amplitude) + "\n";
}

std::string Text(const SweepRequest& request, const std::vector<SweptResponse>& responses) {
  std::string text;
  for (const SweptResponse& swept : responses)
    text += (text.empty() ? "" : "\n") + Heading(swept, request) + Kinematics(swept.answer) + GainTable(swept);
  return text;
}

void Write(const std::filesystem::path& folder, const std::string& json, const Vehicle& vehicle,
           const std::vector<SweptResponse>& responses) {
  OutputFolder output(folder);
  output.Add("response.csv", SweepCsv(responses));
  output.Add("response.svg", SweepSvg(vehicle.name, responses));
  output.Add("result.json", json);
  output.Commit();
  std::fprintf(stderr, "results: %s\n", folder.string().c_str());
}

/// How many frequencies have an answer, of how many. Tells why of the first of each sweep that has none.
struct Count {
  std::size_t answered = 0;
  std::size_t all = 0;
};
Count TellUnanswered(const std::vector<SweptResponse>& responses) {
  Count count;
  for (const SweptResponse& swept : responses) {
    count.all += swept.excitation.frequency_Hz.size();
    count.answered += swept.excitation.frequency_Hz.size() - swept.answer.unanswered.size();
    if (swept.answer.unanswered.empty()) continue;
    std::fprintf(stderr, "%s\n", swept.answer.unanswered.front().why.c_str());
    std::string rest;
    for (std::size_t i = 1; i < swept.answer.unanswered.size(); ++i)
      rest += (i == 1 ? "" : ", ") + Rounded(swept.answer.unanswered[i].frequency_Hz, 3);
    if (!rest.empty())
      std::fprintf(stderr, "%s: nor is there one at %s Hz; --json and result.json tell why\n", swept.mode.c_str(),
                   rest.c_str());
  }
  return count;
}

}  // namespace

int RespondOfVehicle(const ResponseCommand& command) {
  Job job = ReadJob(command);
  if (!command.output.empty()) {
    RequireInputsElsewhere({command.input}, command.output);
    OutputFolder{command.output};
  }
  SteadySolver solver = MakeSolver(job.vehicle);
  RequireStable(job.vehicle, solver);
  for (const Sweep& sweep : job.request.sweeps) FindLocked(job.vehicle, sweep, job.findings);
  const Engine engine = command.engine.value_or(Engine::kAuto);
  Tell(job.findings);
  std::vector<SweptResponse> responses;
  {
    ProgressLine progress;
    for (const Sweep& sweep : job.request.sweeps)
      responses.push_back(
          Sorted(sweep, SolveSweep(solver, sweep.mode, sweep.excitation, engine, {}, progress), job.request.channels));
  }
  const Count count = TellUnanswered(responses);
  if (count.answered == 0) throw std::runtime_error("no periodic motion was found at any frequency");
  const std::string json = SweepJson(job.vehicle, job.request, responses, job.findings);
  if (!command.output.empty()) Write(command.output, json, job.vehicle, responses);
  Print(command.json ? json : Text(job.request, responses));
  return count.answered == count.all ? kGood : kNotGood;
}

}  // namespace fourpost
