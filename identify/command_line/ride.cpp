#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/output_folder.h"
#include "analysis/text/short_number.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/condensed_at_values.h"
#include "identify/command_line/drive.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/locked_friction.h"
#include "identify/command_line/print.h"
#include "identify/command_line/results_line.h"
#include "identify/command_line/ride_points.h"
#include "identify/command_line/ride_text.h"
#include "identify/command_line/run_folder.h"
#include "identify/command_line/solve_history.h"
#include "identify/inspection/file_kind.h"
#include "identify/report/ride_page.h"
#include "identify/run/findings.h"
#include "identify/run/result_kind.h"
#include "vehicles/posts/road.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/requests/engine_text.h"
#include "vehicles/requests/findings.h"
#include "vehicles/requests/option_quantity.h"
#include "vehicles/requests/parameter_setting.h"
#include "vehicles/requests/rigid_range.h"
#include "vehicles/ride/stability.h"
#include "vehicles/ride_metrics/history_ride.h"
#include "vehicles/ride_metrics/road_ride.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;

/// A road's history runs in for this long, and its end fades; both are left out.
constexpr double kRunIn_s = 2;
constexpr double kFade_s = 1;
constexpr double kUsualDuration_s = 60;
constexpr double kWelchUpper_Hz = 50;

struct AskedRoad {
  std::string name;
  std::string road_class;
  double speed = 0;
};

struct RideJob {
  Vehicle vehicle;
  RideInstruments instruments;
  std::vector<AskedRoad> roads;
  Diagnostics findings;
};

fs::path VehicleFileOf(const fs::path& model) {
  if (std::error_code failure; !fs::is_directory(model, failure)) {
    RequireVehicleFile(model);
    return model;
  }
  RequireFitResult(model);
  if (std::error_code failure; !fs::exists(model / "vehicle.urdf", failure))
    Refuse(kRunFileMissing, {model.string()}, {"vehicle.urdf"});
  return model / "vehicle.urdf";
}

std::vector<AskedRoad> ReadRoads(const RideCommand& command, Diagnostics& findings) {
  // ISO 8608:2016, figure B.1.
  constexpr double kLongest_cpm = 0.011;
  constexpr double kShortest_cpm = 2.83;
  std::vector<AskedRoad> roads;
  for (const std::string& text : command.speeds) {
    const std::optional<double> speed = ReadQuantity(text, kVelocity, "--speed", findings);
    if (!speed) continue;
    for (const std::string& road_class : command.roads) {
      const std::string name = "road " + road_class + " at " + ShortNumber(3.6 * *speed) + " km/h";
      roads.push_back({name, road_class, *speed});
    }
    const double lowest = command.drive.first_Hz / *speed;
    const double highest = command.drive.last_Hz / *speed;
    if (lowest < kLongest_cpm || highest > kShortest_cpm)
      findings.Report(kRoadBeyondIso, Place::Option("--speed"), {text, Rounded(lowest, 2), Rounded(highest, 2)});
  }
  return roads;
}

/// Motion sickness is felt below the usual band of roads.
void WarnOfBand(const RideCommand& command, const RideInstruments& instruments, Diagnostics& findings) {
  constexpr double kHighest_Hz = 0.1;
  const bool has_band = !command.roads.empty() || command.drive.motion == SimulateCommand::Motion::kRandom;
  if (!has_band || command.drive.first_Hz <= kHighest_Hz) return;
  for (const RideInstruments::Felt& felt : instruments.points)
    if (felt.weighting == Weighting::kWf)
      findings.Report(kRideBandAboveSickness, Place::Option("--band"), {Rounded(command.drive.first_Hz, 2), felt.name});
}

RideJob ReadJob(const RideCommand& command) {
  const fs::path file = VehicleFileOf(command.drive.model);
  Diagnostics findings = command.drive.faults;
  std::optional<Vehicle> vehicle = ReadVehicle(file, findings);
  if (!vehicle) throw FaultyInput(findings);
  SetParameters(command.drive.set, *vehicle, findings);
  std::vector<AskedRoad> roads = ReadRoads(command, findings);
  SimulateCommand checked = command.drive;
  if (!command.roads.empty()) checked.motion = SimulateCommand::Motion::kRoad;
  CheckMotion(checked, *vehicle, findings);
  RideInstruments instruments = InstrumentRide(*vehicle, ReadRidePoints(command.points, *vehicle, findings));
  SetWeightings(command.weightings, instruments, findings);
  WarnOfBand(command, instruments, findings);
  if (findings.HasErrors()) throw FaultyInput(findings);
  return {std::move(*vehicle), std::move(instruments), std::move(roads), std::move(findings)};
}

/// Elements whose laws act so rarely or so hard that a normal motion describes them roughly.
void WarnOfContacts(const RideAnswer& ride, Diagnostics& findings) {
  constexpr double kOften = 0.01;
  const RideMetrics::Wheel* lifted = nullptr;
  for (const RideMetrics::Wheel& wheel : ride.metrics.wheels)
    if (wheel.off_ground > kOften && (lifted == nullptr || wheel.off_ground > lifted->off_ground)) lifted = &wheel;
  if (lifted != nullptr)
    findings.Report(kRideNotNormal, {},
                    {ride.motion, lifted->tyre, "is off the ground", Percent(lifted->off_ground, 2)});
  const RideMetrics::Stop* hit = nullptr;
  for (const RideMetrics::Stop& stop : ride.metrics.stops)
    if (stop.contact > kOften && (hit == nullptr || stop.contact > hit->contact)) hit = &stop;
  if (hit != nullptr)
    findings.Report(kRideNotNormal, {}, {ride.motion, hit->stop, "is in contact", Percent(hit->contact, 2)});
}

/// `is_random`: a motion whose strongest second is a matter of chance, so that only its dose counts.
void WarnOfShocks(const RideAnswer& ride, bool is_random, Diagnostics& findings) {
  const RideMetrics::Comfort* worst = nullptr;
  for (const RideMetrics::Comfort& comfort : ride.metrics.comfort) {
    const WeightedAcceleration& weighted = comfort.weighted;
    const bool suffices = is_random ? weighted.VdvRatio() <= WeightedAcceleration::kMostVdv : weighted.RmsSuffices();
    if (!suffices && (worst == nullptr || weighted.VdvRatio() > worst->weighted.VdvRatio())) worst = &comfort;
  }
  if (worst == nullptr) return;
  findings.Report(
      kRideShocks, {},
      {worst->point, ride.motion, Rounded(worst->weighted.MtvvRatio(), 3), Rounded(worst->weighted.VdvRatio(), 3)});
}

RideAnswer BySpectra(const RideCommand& command, const RideJob& job, const CondensedModel& model,
                     const AskedRoad& asked, Diagnostics& findings) {
  const std::vector<double> values = job.vehicle.ParameterValues();
  RoadRide ride = RideOnRoad(job.instruments, model, values,
                             {.roughness_m3 = RoadRoughness(asked.road_class).value(),
                              .speed = asked.speed,
                              .lower_Hz = command.drive.first_Hz,
                              .upper_Hz = command.drive.last_Hz,
                              .duration_s = command.drive.duration_s.value_or(kUsualDuration_s)});
  constexpr double kCoarse = 0.005;
  if (!ride.converged) findings.Report(kRideUnconverged, {}, {asked.name});
  else if (ride.grid_change > kCoarse) findings.Report(kRideGridCoarse, {}, {asked.name, Percent(ride.grid_change, 2)});
  RideAnswer answer{.motion = asked.name,
                    .road_class = asked.road_class,
                    .speed = asked.speed,
                    .metrics = std::move(ride.metrics),
                    .spectra = std::move(ride.spectra),
                    .gains = BodyGainsOf(job.instruments, RandomVehicle(model, ride.grid), ride.gains),
                    .converged = ride.converged,
                    .nonlinear = ride.nonlinear,
                    .grid_change = ride.grid_change};
  WarnOfContacts(answer, findings);
  return answer;
}

/// A rig's stroke is no limit of a road.
Drive DriveOn(const RideCommand& command, const Vehicle& vehicle, const AskedRoad& asked) {
  const RandomRoad road{.roughness_m3 = RoadRoughness(asked.road_class).value(),
                        .speed = asked.speed,
                        .lower_Hz = command.drive.first_Hz,
                        .upper_Hz = command.drive.last_Hz,
                        .duration_s = command.drive.duration_s.value_or(kUsualDuration_s) + kRunIn_s + kFade_s,
                        .seed = command.drive.seed};
  return {.name = asked.name,
          .motion = road.MotionOf(vehicle),
          .end_s = road.duration_s - kFade_s,
          .upper_Hz = road.upper_Hz};
}

/// Empty where it was interrupted.
std::optional<RideAnswer> ByHistory(const RideCommand& command, const RideJob& job, const CondensedModel& model,
                                    const Drive& drive, double run_in_s, Diagnostics& findings) {
  AnsweredHistory solved = SolveHistory(command.drive, job.instruments.vehicle, drive, findings);
  if (solved.answer.ended) return {};
  TimeHistory& history = solved.answer.history;
  history.DropFirst(TimeGrid{drive.start_s, drive.end_s, command.drive.rate_Hz, drive.lead_s}.lead_count() +
                    std::lround(run_in_s * command.drive.rate_Hz));
  WarnOfLocked(job.vehicle, solved.locked, "this motion", findings);
  WarnOfPulls(job.vehicle, solved.pulls, "samples", "this motion", findings);
  const std::vector<double> values = job.vehicle.ParameterValues();
  const double upper = drive.upper_Hz > 0 ? drive.upper_Hz : kWelchUpper_Hz;
  return RideAnswer{.motion = drive.name,
                    .metrics = RideOfHistory(job.instruments, model, values, history),
                    .spectra = SpectraOf(job.instruments, history, std::min(upper, 0.4 * command.drive.rate_Hz)),
                    .by_spectra = false,
                    .by = solved.answer.by};
}

std::string PageOf(const RideCommand& command, const RideJob& job, const std::vector<RideAnswer>& rides) {
  ShownRides shown{
      .file = VehicleTextWithValues(job.vehicle, job.vehicle.ParameterValues(), fs::absolute(command.output)),
      .rides = rides,
      .first = {.instruments = job.instruments},
      .findings = job.findings};
  if (!job.roads.empty()) {
    shown.first.road_class = job.roads.front().road_class;
    shown.first.speed = job.roads.front().speed;
    shown.first.lower_Hz = command.drive.first_Hz;
    shown.first.upper_Hz = command.drive.last_Hz;
  }
  return RidePage(job.vehicle, shown);
}

void Write(const RideCommand& command, const RideJob& job, const std::vector<RideAnswer>& rides,
           const std::string& json) {
  OutputFolder output(command.output);
  output.Add(kPageName, PageOf(command, job, rides));
  output.Add("metrics.csv", RideCsv(rides));
  output.Add("spectra.csv", RideSpectraCsv(rides));
  output.Add("ride.svg", RideSvg(job.vehicle.name, rides));
  output.Add("result.json", json);
  output.Commit();
  PrintResultsLine(command.output);
}

/// All rides asked for, and their text. Ends early where one was interrupted.
class Riding {
 public:
  Riding(const RideCommand& command, const RideJob& job, const CondensedModel& model)
      : command_(command), job_(job), model_(model) {}

  void Run() {
    if (job_.roads.empty()) {
      const Drive drive = DriveOf(command_.drive, job_.vehicle, findings_);
      if (std::optional<RideAnswer> ride = ByHistory(command_, job_, model_, drive, 0, findings_)) {
        using Motion = SimulateCommand::Motion;
        const bool is_random = command_.drive.motion == Motion::kRandom;
        if (is_random || command_.drive.motion == Motion::kRecording) WarnOfShocks(*ride, is_random, findings_);
        Take(std::move(*ride));
      } else {
        interrupted_ = true;
      }
      return;
    }
    WarnAboveRigid(command_.drive.last_Hz, "--band", findings_);
    for (const AskedRoad& asked : job_.roads) {
      Take(BySpectra(command_, job_, model_, asked, findings_));
      if (!command_.over_time) continue;
      const RideAnswer spectra = rides_.back();
      std::optional<RideAnswer> history =
          ByHistory(command_, job_, model_, DriveOn(command_, job_.vehicle, asked), kRunIn_s, findings_);
      if (!history) {
        interrupted_ = true;
        return;
      }
      WarnOfShocks(*history, true, findings_);
      const std::string difference = RideDifferenceText(spectra, *history);
      Take(std::move(*history));
      text_ += '\n' + difference;
    }
  }

  const std::vector<RideAnswer>& rides() const { return rides_; }
  const std::string& text() const { return text_; }
  const Diagnostics& findings() const { return findings_; }
  bool interrupted() const { return interrupted_; }

 private:
  void Take(RideAnswer ride) {
    text_ += (text_.empty() ? "" : "\n") + RideText(ride);
    rides_.push_back(std::move(ride));
  }

  const RideCommand& command_;
  const RideJob& job_;
  const CondensedModel& model_;
  std::vector<RideAnswer> rides_;
  std::string text_;
  Diagnostics findings_;
  bool interrupted_ = false;
};

}  // namespace

int Run(const RideCommand& command) {
  RideJob job = ReadJob(command);
  if (!command.output.empty()) {
    std::vector<fs::path> inputs = {VehicleFileOf(command.drive.model)};
    if (!command.drive.recording.empty()) inputs.push_back(command.drive.recording);
    RequireInputsElsewhere(inputs, command.output);
    RequireNoOtherResult(command.output, ResultKind::kRide);
    OutputFolder{command.output};
  }
  Tell(job.findings);
  const CondensedModel model = CondensedAtValues(job.instruments.vehicle);
  if (const std::optional<Growth> growth = GrowthOf(job.vehicle, model); growth && !job.roads.empty())
    Refuse(kUnstable, {job.vehicle.file}, {growth->Text()});
  CatchInterrupts();
  Riding riding(command, job, model);
  riding.Run();
  Tell(riding.findings());
  if (riding.rides().empty()) {
    Tell(kInterruptedAtStart);
    return kInterrupted;
  }
  for (const Diagnostic& item : riding.findings().items()) job.findings.Add(item);
  const std::string json = RideJson(job.vehicle, riding.rides(), job.findings);
  if (!command.output.empty()) Write(command, job, riding.rides(), json);
  if (command.json) Print(json);
  else PrintText(riding.text());
  return riding.interrupted() ? kInterrupted : kGood;
}

}  // namespace fourpost
