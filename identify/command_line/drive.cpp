#include "identify/command_line/drive.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/text/number.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/findings.h"
#include "identify/inspection/file_kind.h"
#include "vehicles/posts/height_signals.h"
#include "vehicles/posts/post_motions.h"
#include "vehicles/posts/recorded_posts.h"
#include "vehicles/posts/road.h"
#include "vehicles/requests/amplitude_limits.h"
#include "vehicles/requests/post_shape.h"
#include "vehicles/requests/rigid_range.h"
#include "vehicles/response/post_stroke.h"

namespace fourpost {
namespace {

using Motion = SimulateCommand::Motion;

constexpr double kStepStart_s = 0.5;

const char* OptionOf(Motion motion) {
  switch (motion) {
    case Motion::kSweep: return "--sweep";
    case Motion::kSine: return "--sine";
    case Motion::kStep: return "--step";
    case Motion::kRandom: return "--random";
    case Motion::kRoad: return "--road";
    case Motion::kRecording: return "--recording";
  }
  return "";
}

std::string Hertz(double value) { return FormatNumber(value) + " Hz"; }

std::string Seconds(double value) { return FormatNumber(value) + " s"; }

double Duration(const SimulateCommand& command) {
  const double usual = command.motion == Motion::kStep ? 5 : command.motion == Motion::kSine ? 10 : 60;
  return command.duration_s.value_or(usual);
}

std::vector<double> Shape(const SimulateCommand& command, const Vehicle& vehicle) {
  Diagnostics known;
  return ReadPostShape(command.mode, vehicle, known);
}

/// Evenly in octaves, ends included.
std::vector<double> FrequenciesOf(const SimulateCommand& command) {
  constexpr int kSteps = 32;
  std::vector<double> frequencies;
  for (int i = 0; i <= kSteps; ++i)
    frequencies.push_back(command.first_Hz *
                          std::pow(command.last_Hz / command.first_Hz, static_cast<double>(i) / kSteps));
  return frequencies;
}

Drive Swept(const SimulateCommand& command, const Vehicle& vehicle, Diagnostics& findings) {
  const AmplitudeLaw law = ReadLimits(command.limits, findings);
  WarnBeyondUsual(law, FrequenciesOf(command), findings);
  const SweptSine sweep{.first_Hz = command.first_Hz,
                        .last_Hz = command.last_Hz,
                        .duration_s = Duration(command),
                        .amplitude_m = law.displacement_m,
                        .top_speed = law.velocity_mps,
                        .top_acceleration = law.acceleration_mps2,
                        .logarithmic = !command.linear_sweep};
  const std::string name = command.motion == Motion::kSine ? "sine of " + Rounded(sweep.first_Hz, 3) + " Hz"
                                                           : "sweep from " + Rounded(sweep.first_Hz, 3) + " to " +
                                                                 Rounded(sweep.last_Hz, 3) + " Hz";
  return {.name = name + " in " + command.mode + ", at most " + LimitsText(law),
          .motion = FollowPattern(sweep.Signal(), Shape(command, vehicle)),
          .end_s = sweep.duration_s,
          .upper_Hz = std::max(sweep.first_Hz, sweep.last_Hz)};
}

Drive Stepped(const SimulateCommand& command, const Vehicle& vehicle) {
  const SmoothStep step{.height_m = command.height_m, .rise_s = command.rise_s, .start_s = kStepStart_s};
  return {.name = "step of " + Rounded(1e3 * step.height_m, 3) + " mm in " + command.mode,
          .motion = FollowPattern(step.Signal(), Shape(command, vehicle)),
          .end_s = Duration(command)};
}

Drive Shaken(const SimulateCommand& command, const Vehicle& vehicle) {
  const RandomHeights random{.rms_m = command.height_m,
                             .lower_Hz = command.first_Hz,
                             .upper_Hz = command.last_Hz,
                             .duration_s = Duration(command),
                             .seed = command.seed};
  return {.name = "random heights of " + Rounded(1e3 * random.rms_m, 3) + " mm rms in " + command.mode,
          .motion = FollowPattern(random.Signal(), Shape(command, vehicle)),
          .end_s = random.duration_s,
          .upper_Hz = random.upper_Hz};
}

Drive Driven(const SimulateCommand& command, const Vehicle& vehicle) {
  const RandomRoad road{.roughness_m3 = RoadRoughness(command.road_class).value(),
                        .speed = command.speed,
                        .lower_Hz = command.first_Hz,
                        .upper_Hz = command.last_Hz,
                        .duration_s = Duration(command),
                        .seed = command.seed};
  return {.name = "road " + command.road_class + " at " + Rounded(3.6 * road.speed, 3) + " km/h",
          .motion = road.MotionOf(vehicle),
          .end_s = road.duration_s,
          .upper_Hz = road.upper_Hz};
}

Drive Replayed(const SimulateCommand& command, const Vehicle& vehicle, Diagnostics& findings) {
  RequireTable(command.recording);
  Diagnostics diagnostics;
  std::optional<RecordedPosts> record = ReadRecordedPosts(command.recording, vehicle, diagnostics);
  if (!record) throw FaultyInput(diagnostics);
  if (const double length = record->end_s - record->start_s; command.duration_s.value_or(0) > length * (1 + 1e-9))
    findings.Report(kRecordingEnds, Place::Option("--duration"), {Seconds(length)});
  const double end =
      command.duration_s ? std::min(record->end_s, record->start_s + *command.duration_s) : record->end_s;
  return {.name = "recording " + command.recording.filename().string(),
          .motion = std::move(record->motion),
          .start_s = record->start_s,
          .end_s = end,
          .lead_s = record->lead_s};
}

Drive MotionAskedFor(const SimulateCommand& command, const Vehicle& vehicle, Diagnostics& findings) {
  switch (command.motion) {
    case Motion::kSweep:
    case Motion::kSine: return Swept(command, vehicle, findings);
    case Motion::kStep: return Stepped(command, vehicle);
    case Motion::kRandom: return Shaken(command, vehicle);
    case Motion::kRoad: return Driven(command, vehicle);
    case Motion::kRecording: return Replayed(command, vehicle, findings);
  }
  throw std::logic_error("no such motion");
}

void RequireStroke(const SimulateCommand& command, const Vehicle& vehicle, const Drive& drive) {
  // Of twenty samples in a period of the highest frequency a peak is missed by 1.2 % at the most.
  const double step = 1 / std::max(1000.0, 20 * drive.upper_Hz);
  std::vector<double> farthest =
      FarthestHeights(drive.motion, vehicle.posts.size(), drive.start_s - drive.lead_s, drive.end_s, step);
  for (double& height : farthest) height = std::abs(height);
  Diagnostics faults;
  CheckStroke(vehicle, farthest, "this motion", faults, ReadStroke(command.stroke, faults));
  if (faults.HasErrors()) throw FaultyInput(faults);
}

void CheckSampling(const SimulateCommand& command, Diagnostics& diagnostics) {
  // As analysers sample: more would alias peaks away.
  constexpr double kLeastSamplesPerPeriod = 2.56;
  // Of each channel: some minutes of work, some gigabytes of text.
  constexpr double kMostSamples = 2e7;
  const bool has_band = command.motion != Motion::kStep && command.motion != Motion::kRecording;
  const double upper_Hz = has_band ? std::max(command.first_Hz, command.last_Hz) : 0;
  if (command.rate_Hz < kLeastSamplesPerPeriod * upper_Hz)
    diagnostics.Report(kRateTooLow, Place::Option("--rate"),
                       {Hertz(command.rate_Hz), Hertz(upper_Hz), Hertz(kLeastSamplesPerPeriod * upper_Hz)});
  if (command.filter_Hz && !(*command.filter_Hz < command.rate_Hz / 2))
    diagnostics.Report(kFilterTooHigh, Place::Option("--filter"), {Hertz(*command.filter_Hz), Hertz(command.rate_Hz)});
  if (!(command.rate_Hz * Duration(command) <= kMostSamples))
    diagnostics.Report(kHistoryTooLong, Place::Option("--duration"),
                       {Seconds(Duration(command)), Hertz(command.rate_Hz), FormatNumber(kMostSamples)});
  if (!(command.rate_Hz * Duration(command) >= 1))
    diagnostics.Report(kHistoryTooShort, Place::Option("--duration"),
                       {Seconds(Duration(command)), Hertz(command.rate_Hz)});
  const double step_end = kStepStart_s + command.rise_s;
  if (command.motion == Motion::kStep && !(Duration(command) > step_end))
    diagnostics.Report(kStepCutShort, Place::Option("--duration"),
                       {Seconds(Duration(command)), Seconds(kStepStart_s), Seconds(command.rise_s), Seconds(step_end)});
}

}  // namespace

void CheckMotion(const SimulateCommand& command, const Vehicle& vehicle, Diagnostics& diagnostics) {
  const bool has_mode = command.motion != Motion::kRoad && command.motion != Motion::kRecording;
  if (vehicle.posts.empty()) diagnostics.Report(kVehicleWithoutPosts, {vehicle.file});
  else if (has_mode) ReadPostShape(command.mode, vehicle, diagnostics);
  ReadLimits(command.limits, diagnostics);
  ReadStroke(command.stroke, diagnostics);
  CheckSampling(command, diagnostics);
}

Drive DriveOf(const SimulateCommand& command, const Vehicle& vehicle, Diagnostics& findings) {
  try {
    Drive drive = MotionAskedFor(command, vehicle, findings);
    RequireStroke(command, vehicle, drive);
    const bool has_band = command.motion == Motion::kRandom || command.motion == Motion::kRoad;
    WarnAboveRigid(drive.upper_Hz, has_band ? "--band" : OptionOf(command.motion), findings);
    return drive;
  } catch (const std::invalid_argument& fault) {
    Refuse(kMotionImpossible, Place::Option(OptionOf(command.motion)), {fault.what()});
  }
}

}  // namespace fourpost
