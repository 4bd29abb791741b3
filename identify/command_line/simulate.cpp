#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/csv_writer.h"
#include "analysis/nearest.h"
#include "analysis/number.h"
#include "analysis/output_folder.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/print.h"
#include "identify/command_line/progress_line.h"
#include "identify/command_line/text_table.h"
#include "identify/history_chart.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/posts/height_signals.h"
#include "vehicles/posts/post_motions.h"
#include "vehicles/posts/recorded_posts.h"
#include "vehicles/posts/road.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/response/post_stroke.h"
#include "vehicles/response/response_recorder.h"
#include "vehicles/ride/stability.h"
#include "vehicles/simulation/multibody_system.h"
#include "vehicles/simulation/sensor_model.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// What cannot be asked of this vehicle, told like a fault of its file.
[[noreturn]] void Refuse(const Vehicle& vehicle, const std::string& message) {
  Diagnostics faults;
  faults.Error(vehicle.file, 0, message);
  throw FaultyInput(faults);
}

/// How the posts move, and when.
struct Drive {
  PostMotion motion;
  double start_s = 0;
  double end_s = 0;
  double lead_s = 0;
  /// Highest frequency of what the posts are asked to do; 0: none in particular.
  double upper_Hz = 0;
};

std::vector<double> Shape(const Vehicle& vehicle, const std::string& mode) {
  try {
    return PostPattern(vehicle, mode);
  } catch (const std::invalid_argument& fault) {
    Refuse(vehicle, std::string("--mode ") + mode + ": " + fault.what());
  }
}

double Duration(const SimulateCommand& command) {
  const bool is_sine = command.motion == SimulateCommand::Motion::kSweep && command.first_Hz == command.last_Hz;
  const bool is_step = command.motion == SimulateCommand::Motion::kStep;
  return command.duration_s.value_or(is_step ? 5 : is_sine ? 10 : 60);
}

Drive Swept(const SimulateCommand& command, const Vehicle& vehicle) {
  const SweptSine sweep{.first_Hz = command.first_Hz,
                        .last_Hz = command.last_Hz,
                        .duration_s = Duration(command),
                        .amplitude_m = command.amplitude_m,
                        .top_speed = command.top_speed,
                        .logarithmic = !command.linear_sweep};
  return {FollowPattern(sweep.Signal(), Shape(vehicle, command.mode)), 0, sweep.duration_s, 0,
          std::max(sweep.first_Hz, sweep.last_Hz)};
}

Drive Stepped(const SimulateCommand& command, const Vehicle& vehicle) {
  const SmoothStep step{.height_m = command.amplitude_m, .rise_s = command.rise_s, .start_s = 0.5};
  return {FollowPattern(step.Signal(), Shape(vehicle, command.mode)), 0, Duration(command), 0, 0};
}

Drive Shaken(const SimulateCommand& command, const Vehicle& vehicle) {
  const RandomHeights random{.rms_m = command.amplitude_m,
                             .lower_Hz = command.first_Hz,
                             .upper_Hz = command.last_Hz,
                             .duration_s = Duration(command),
                             .seed = command.seed};
  return {FollowPattern(random.Signal(), Shape(vehicle, command.mode)), 0, random.duration_s, 0, random.upper_Hz};
}

Drive Driven(const SimulateCommand& command, const Vehicle& vehicle) {
  const RandomRoad road{.roughness_m3 = RoadRoughness(command.road_class).value(),
                        .speed = command.speed,
                        .lower_Hz = command.first_Hz,
                        .upper_Hz = command.last_Hz,
                        .duration_s = Duration(command),
                        .seed = command.seed};
  return {road.MotionOf(vehicle), 0, road.duration_s, 0, road.upper_Hz};
}

Drive Replayed(const SimulateCommand& command, const Vehicle& vehicle) {
  Diagnostics diagnostics;
  std::optional<RecordedPosts> record = ReadRecordedPosts(command.recording, vehicle, diagnostics);
  if (!record) throw FaultyInput(diagnostics);
  const double end =
      command.duration_s ? std::min(record->end_s, record->start_s + *command.duration_s) : record->end_s;
  return {std::move(record->motion), record->start_s, end, record->lead_s, 0};
}

Drive DriveOf(const SimulateCommand& command, const Vehicle& vehicle) try {
  switch (command.motion) {
    case SimulateCommand::Motion::kSweep: return Swept(command, vehicle);
    case SimulateCommand::Motion::kStep: return Stepped(command, vehicle);
    case SimulateCommand::Motion::kRandom: return Shaken(command, vehicle);
    case SimulateCommand::Motion::kRoad: return Driven(command, vehicle);
    case SimulateCommand::Motion::kRecording: return Replayed(command, vehicle);
  }
  throw std::logic_error("no such motion");
} catch (const std::invalid_argument& fault) {
  Refuse(vehicle, fault.what());
}

/// As analysers sample: more would alias peaks away.
constexpr double kLeastSamplesPerPeriod = 2.56;
/// Of each channel: some minutes of work, some gigabytes of text.
constexpr double kMostSamples = 2e7;

/// Before any motion is made; a recording, whose duration is not known yet, holds what it holds.
void CheckSampling(const SimulateCommand& command) {
  using Motion = SimulateCommand::Motion;
  Diagnostics faults;
  const bool has_band = command.motion != Motion::kStep && command.motion != Motion::kRecording;
  const double upper_Hz = has_band ? std::max(command.first_Hz, command.last_Hz) : 0;
  if (command.rate_Hz < kLeastSamplesPerPeriod * upper_Hz)
    faults.Error("--rate", 0,
                 FormatNumber(command.rate_Hz) + " Hz is too slow for motions up to " + FormatNumber(upper_Hz) +
                     " Hz; take " + FormatNumber(kLeastSamplesPerPeriod * upper_Hz) + " Hz or more");
  if (command.filter_Hz && !(*command.filter_Hz < command.rate_Hz / 2))
    faults.Error("--filter", 0,
                 FormatNumber(*command.filter_Hz) + " Hz must be below half the rate of " +
                     FormatNumber(command.rate_Hz) + " Hz");
  if (!(command.rate_Hz * Duration(command) <= kMostSamples))
    faults.Error("--duration", 0,
                 FormatNumber(Duration(command)) + " s at " + FormatNumber(command.rate_Hz) + " Hz are more than " +
                     FormatNumber(kMostSamples) + " samples; take less of either");
  if (faults.HasErrors()) throw FaultyInput(faults);
}

void RequireStroke(const SimulateCommand& command, const Vehicle& vehicle, const Drive& drive) {
  // Of twenty samples in a period of the highest frequency a peak is missed by 1.2 % at the most.
  const double step = 1 / std::max(1000.0, 20 * drive.upper_Hz);
  std::vector<double> farthest =
      FarthestHeights(drive.motion, vehicle.posts.size(), drive.start_s - drive.lead_s, drive.end_s, step);
  for (double& height : farthest) height = std::abs(height);
  Diagnostics faults;
  CheckStroke(vehicle, farthest, "this motion", faults, command.stroke_m);
  if (faults.HasErrors()) throw FaultyInput(faults);
}

/// Indices of the sensors asked for; all without a word.
std::vector<std::size_t> ChosenSensors(const SimulateCommand& command, const Vehicle& vehicle) {
  std::vector<std::string> names;
  for (const Sensor& sensor : vehicle.sensors) names.push_back(sensor.name);
  std::vector<std::size_t> chosen;
  if (command.channels.empty())
    for (std::size_t i = 0; i < names.size(); ++i) chosen.push_back(i);
  Diagnostics faults;
  for (const std::string& name : command.channels) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      faults.Error(vehicle.file, 0,
                   "--channels: no sensor of the vehicle is called '" + name + "'" + DidYouMean(name, names));
    else chosen.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  if (faults.HasErrors()) throw FaultyInput(faults);
  return chosen;
}

/// A history has a start: it can be drawn all the same.
void WarnOfGrowth(const Vehicle& vehicle, const CondensedModel& model) {
  const std::optional<Growth> growth = GrowthOf(vehicle, model);
  if (!growth) return;
  Diagnostics findings;
  findings.Warning(vehicle.file, 0,
                   "the vehicle is unstable in its design pose: " + growth->Text() +
                       ", whatever the posts do; see `fourpost check`");
  Tell(findings);
}

/// What an engine answers, and what is to be said about it.
struct Answer {
  TimeHistory history;
  /// Condensed: step and what the last halving changed.
  std::optional<double> step_s;
  std::optional<double> change;
};

Answer Run(const SimulateCommand& command, const Vehicle& vehicle, const Drive& drive) {
  const std::vector<double> values = vehicle.ParameterValues();
  const CondensedVehicle condensed(vehicle);
  const CondensedModel model = condensed.At(values);
  WarnOfGrowth(vehicle, model);
  const TimeGrid grid{drive.start_s, drive.end_s, command.rate_Hz, drive.lead_s};
  ProgressLine line;
  const std::string end = Rounded(drive.end_s, 3) + " s";
  const auto progress = [&](double t) { line.Show("simulate: " + Rounded(std::max(0.0, t), 3) + " of " + end); };
  if (command.full) {
    Multibody multibody(vehicle);
    multibody.SetParameters(values, model.preloads);
    // Simbody weighs states by about 1 m, posts move by millimetres.
    MultibodySystem system(multibody, 1e-3 * command.error);
    return {Simulate(system, drive.motion, grid, progress), std::nullopt, std::nullopt};
  }
  CondensedHistory answer =
      SimulateCondensed(model, RigViewOf(vehicle), drive.motion, grid, {.error = command.error}, progress);
  return {std::move(answer.history), answer.step_s, answer.change};
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

/// Posts first.
std::vector<HistoryChannel> Columns(const Vehicle& vehicle, const TimeHistory& history,
                                    const std::vector<std::size_t>& sensors) {
  std::vector<HistoryChannel> columns;
  for (std::size_t p = 0; p < vehicle.posts.size(); ++p)
    columns.push_back({"post_" + vehicle.posts[p].name, "m", history.posts.col(static_cast<Eigen::Index>(p))});
  for (const std::size_t i : sensors)
    columns.push_back(
        {vehicle.sensors[i].name, UnitOf(vehicle.sensors[i].type), history.readings.col(static_cast<Eigen::Index>(i))});
  return columns;
}

std::string CsvText(const TimeHistory& history, const std::vector<HistoryChannel>& columns) {
  std::vector<std::string> names = {"time"};
  for (const HistoryChannel& column : columns) names.push_back(column.name);
  CsvWriter csv(names);
  csv.Add("s");
  for (const HistoryChannel& column : columns) csv.Add(column.unit);
  // Eight digits: more than any engine's error.
  const auto rounded = [](double value) {
    if (value == 0 || !std::isfinite(value)) return value;
    return ParseNumber(Rounded(value, 8)).value_or(value);
  };
  for (Eigen::Index k = 0; k < history.size(); ++k) {
    csv.Add(std::round(1e9 * history.TimeAt(k)) / 1e9);
    for (const HistoryChannel& column : columns) csv.Add(rounded(column.values[k]));
  }
  return csv.text();
}

/// Before the work, so that none is in vain.
void CheckOutput(const std::filesystem::path& file, const SimulateCommand& command) {
  namespace fs = std::filesystem;
  if (file.empty()) return;
  const auto refuse = [&](const std::string& why) { throw OutputError("cannot write " + file.string() + ": " + why); };
  std::error_code failure;
  if (command.output == command.chart) refuse("-o and --chart name the same file");
  for (const fs::path& input : {command.model, command.recording})
    if (!input.empty() && fs::equivalent(input, file, failure)) refuse("it is an input; give another file");
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, failure)) refuse("there is no folder " + folder.string());
  if (fs::is_directory(file, failure)) refuse("it is a folder; name a file");
}

void WriteFile(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw OutputError("cannot write " + file.string() + ": may it be written to, and is there room?");
}

struct Extent {
  double mean = 0;
  double rms = 0;
  double peak = 0;
  double peak_to_peak = 0;

  explicit Extent(const Eigen::VectorXd& values)
      : mean(values.mean()),
        rms(std::sqrt(values.squaredNorm() / static_cast<double>(values.size()))),
        peak(values.cwiseAbs().maxCoeff()),
        peak_to_peak(values.maxCoeff() - values.minCoeff()) {}
};

std::string SummaryText(const std::vector<HistoryChannel>& columns) {
  TextTable table({"channel", "unit", "mean", "rms", "peak", "peak to peak"});
  for (const HistoryChannel& column : columns) {
    const Extent extent(column.values);
    table.Add({column.name, column.unit, Rounded(extent.mean, 4), Rounded(extent.rms, 4), Rounded(extent.peak, 4),
               Rounded(extent.peak_to_peak, 4)});
  }
  return table.Format();
}

std::string SummaryJson(const SimulateCommand& command, const Answer& answer,
                        const std::vector<HistoryChannel>& columns) {
  Json channels = Json::array();
  for (const HistoryChannel& column : columns) {
    const Extent extent(column.values);
    channels.push_back({{"name", column.name},
                        {"unit", column.unit},
                        {"mean", extent.mean},
                        {"rms", extent.rms},
                        {"peak", extent.peak},
                        {"peak_to_peak", extent.peak_to_peak}});
  }
  Json out = {{"vehicle", command.model.string()}, {"engine", command.full ? "full" : "condensed"},
              {"start_s", answer.history.start_s}, {"rate_Hz", answer.history.rate_Hz},
              {"samples", answer.history.size()},  {"seed", command.seed}};
  if (answer.step_s) out["step_s"] = *answer.step_s;
  if (answer.change) out["error"] = *answer.change;
  out["channels"] = std::move(channels);
  return out.dump(2) + '\n';
}

}  // namespace

int Run(const SimulateCommand& command) {
  CheckOutput(command.output, command);
  CheckOutput(command.chart, command);
  Diagnostics diagnostics;
  const std::optional<Vehicle> vehicle = ReadVehicle(command.model, diagnostics);
  if (!vehicle) throw FaultyInput(diagnostics);
  Tell(diagnostics);
  if (vehicle->posts.empty()) Refuse(*vehicle, "the vehicle has no fp:post to move; add one under each tyre");
  const std::vector<std::size_t> sensors = ChosenSensors(command, *vehicle);
  CheckSampling(command);
  const Drive drive = DriveOf(command, *vehicle);
  RequireStroke(command, *vehicle, drive);
  Answer answer = Run(command, *vehicle, drive);
  Record(command, drive, answer.history);
  if (answer.change && *answer.change > command.error)
    std::fprintf(stderr, "warning: halving the step down to %s us still changes a channel by %s %% of its rms\n",
                 Rounded(1e6 * *answer.step_s, 3).c_str(), Rounded(100 * *answer.change, 3).c_str());
  const std::vector<HistoryChannel> columns = Columns(*vehicle, answer.history, sensors);
  if (!command.output.empty()) WriteFile(command.output, CsvText(answer.history, columns));
  if (!command.chart.empty())
    WriteFile(command.chart, HistorySvg(vehicle->name, answer.history.start_s, answer.history.rate_Hz, columns));
  if (command.json) Print(SummaryJson(command, answer, columns));
  else Print(command.output.empty() ? CsvText(answer.history, columns) : SummaryText(columns));
  return kGood;
}

}  // namespace fourpost
