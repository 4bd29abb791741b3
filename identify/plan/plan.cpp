#include "identify/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <system_error>

#include "analysis/files/text_file.h"
#include "analysis/text/text_table.h"
#include "identify/plan/findings.h"
#include "identify/plan/known_parameters.h"
#include "identify/plan/recorded_noise.h"
#include "identify/plan/run_readings.h"
#include "identify/search/parallel.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {
namespace {

using Eigen::Index;

class Planner {
 public:
  Planner(const PlanRequest& request, const WorkHooks& hooks) : request_(request), hooks_(hooks) {}

  Plan Run() {
    Read();
    const std::vector<PossibleRun> possible = PossibleRuns();
    if (hooks_.IsStopped()) {
      plan_.is_interrupted = true;
      return std::move(plan_);
    }
    hooks_.Show("plan: choosing among " + std::to_string(possible.size()) + " runs and measurements");
    RequireTime(possible);
    const DesignGoal goal{.budget_s = plan_.rig.time_s, .targets = Targets()};
    plan_.design = BestDesign(known_.information, possible, goal);
    for (std::size_t c = 0; c < possible.size(); ++c) plan_.runs[c].repeats = plan_.design.repeats[c];
    Describe(possible);
    return std::move(plan_);
  }

 private:
  void Read() {
    std::error_code failure;
    const bool is_run = std::filesystem::is_directory(request_.run, failure);
    Diagnostics faults;
    std::optional<Vehicle> vehicle = ReadVehicle(is_run ? request_.run / "vehicle.urdf" : request_.run, faults);
    if (!vehicle) throw FaultyInput(faults);
    const Place place{request_.run.string()};
    if (vehicle->posts.empty() || vehicle->sensors.empty()) Refuse(kPlanWithoutPosts, place, {});
    plan_.subject = request_.run.filename().string();
    if (plan_.subject.empty()) plan_.subject = request_.run.parent_path().filename().string();
    plan_.vehicle = *std::move(vehicle);
    known_ = is_run ? KnownByFit(request_.run, plan_.vehicle) : KnownByRanges(plan_.vehicle);
    if (known_.places.empty()) Refuse(kPlanWithoutParameters, place, {});
    plan_.rig = UsualRig(plan_.vehicle);
    if (!request_.rig.empty()) {
      const std::optional<std::string> text = ReadTextFile(request_.rig, faults);
      std::optional<RigFile> rig;
      if (text) rig = ReadRigText(*text, request_.rig, plan_.vehicle, known_.places, faults);
      if (!rig) throw FaultyInput(faults);
      plan_.rig = *std::move(rig);
    }
    plan_.findings.Add(faults);
    if (is_run) TakeFromFit();
    if (request_.time_s) plan_.rig.time_s = *request_.time_s;
  }

  std::vector<PossibleRun> PossibleRuns() {
    const CondensedVehicle car(plan_.vehicle);
    const RigFile& rig = plan_.rig;
    std::vector<AnsweredRun> answers(rig.runs.size());
    std::mutex shown;
    std::size_t done = 0;
    ForEachInParallel(rig.runs.size(), ThreadCount(request_.threads), [&](std::size_t r) {
      if (hooks_.IsStopped()) return;
      answers[r] = AnswerTo(rig.runs[r], car, known_);
      const std::lock_guard lock(shown);
      hooks_.Show("plan: computed " + std::to_string(++done) + " of " + std::to_string(rig.runs.size()) + " runs");
    });
    std::vector<PossibleRun> possible;
    if (hooks_.IsStopped()) return possible;
    AssumeNoise(LargestAmplitudes(plan_.vehicle, rig, answers));
    for (std::size_t r = 0; r < rig.runs.size(); ++r) {
      if (!answers[r].failure.empty()) {
        plan_.findings.Report(kPlanRunWithoutMotion, {request_.rig.string()}, {rig.runs[r].name, answers[r].failure});
        continue;
      }
      possible.push_back(ReadingsOf(rig.runs[r], answers[r], plan_.vehicle, rig, known_));
      plan_.runs.push_back({.name = rig.runs[r].name, .time_s = possible.back().cost_s, .run = r});
    }
    for (const DirectMeasurement& measurement : rig.measurements) {
      possible.push_back(ReadingsOf(measurement, plan_.vehicle, known_));
      plan_.runs.push_back({.name = measurement.name, .time_s = measurement.time_s});
    }
    return possible;
  }

  /// What the rig's file does not state: noise, sensors that the recordings had, the model error of the study.
  void TakeFromFit() {
    plan_.is_of_fit = true;
    if (!known_.left_out.empty()) plan_.findings.Report(kPlanLeftOut, {request_.run.string()}, {known_.left_out});
    Diagnostics ignored;
    const std::optional<std::string> study = ReadTextFile(request_.run / "study.yaml", ignored);
    if (study && !plan_.rig.states_model_error) plan_.rig.model_error = ModelErrorOf(*study);
    const std::vector<double> recorded = RecordedNoise(request_.run, plan_.vehicle);
    const bool is_any = std::any_of(recorded.begin(), recorded.end(), [](double noise) { return !std::isnan(noise); });
    for (std::size_t s = 0; s < recorded.size() && is_any && !plan_.rig.states_sensors; ++s)
      plan_.rig.is_read[s] = !std::isnan(recorded[s]);
    for (std::size_t s = 0; s < recorded.size(); ++s)
      if (std::isnan(plan_.rig.noise[s])) plan_.rig.noise[s] = recorded[s];
  }

  void AssumeNoise(const Eigen::VectorXd& largest) {
    constexpr double kShare = 0.01;
    std::string names;
    for (std::size_t s = 0; s < plan_.vehicle.sensors.size(); ++s) {
      double& noise = plan_.rig.noise[s];
      if (!std::isnan(noise) || !plan_.rig.is_read[s]) continue;
      noise = kShare * AmplitudeForNoise(s, largest);
      names += (names.empty() ? "'" : ", '") + plan_.vehicle.sensors[s].name + '\'';
    }
    if (!names.empty()) plan_.findings.Report(kPlanNoiseAssumed, {request_.rig.string()}, {names});
  }

  /// A sensor that no run moves shows what the balance's iteration leaves, some 1e-6, and would seem exact with a share
  /// of that: it counts as the loudest of its unit, or as the posts' own motion where none is loud.
  double AmplitudeForNoise(std::size_t sensor, const Eigen::VectorXd& largest) const {
    constexpr double kStill = 1e-4;
    const std::vector<Sensor>& sensors = plan_.vehicle.sensors;
    double loudest = LargestOfPosts(sensors[sensor].type);
    for (std::size_t s = 0; s < sensors.size(); ++s)
      if (UnitOf(sensors[s].type) == UnitOf(sensors[sensor].type))
        loudest = std::max(loudest, largest[static_cast<Index>(s)]);
    const double own = largest[static_cast<Index>(sensor)];
    return own > kStill * loudest ? own : loudest;
  }

  /// Of all runs, in the unit of such a sensor: angular velocities over a lever of 1 m; forces are the tyres' own.
  double LargestOfPosts(Sensor::Type type) const {
    double most = 0;
    if (type == Sensor::Type::kLoadCell) return most;
    for (const RigRun& run : plan_.rig.runs)
      for (const double frequency : run.frequency_Hz) {
        const double amplitude = run.amplitude.At(frequency);
        const double turning = type == Sensor::Type::kGyro ? 2 * std::numbers::pi * frequency : 1;
        most = std::max(most, turning * amplitude * std::abs(ReferencePerMetre(type, frequency)));
      }
    return most;
  }

  void RequireTime(const std::vector<PossibleRun>& possible) {
    const bool any = std::any_of(possible.begin(), possible.end(),
                                 [&](const PossibleRun& one) { return one.cost_s <= plan_.rig.time_s; });
    if (any) return;
    Diagnostics faults;
    faults.Add(plan_.findings);
    faults.Report(kPlanNothingAffordable, {request_.rig.string()}, {Rounded(plan_.rig.time_s / 60, 3) + " min"});
    throw FaultyInput(faults);
  }

  Eigen::VectorXd Targets() const {
    if (plan_.rig.wanted.empty()) return {};
    Eigen::VectorXd targets = Eigen::VectorXd::Constant(known_.slopes.size(), std::numeric_limits<double>::infinity());
    for (const WantedDeviation& wanted : plan_.rig.wanted)
      for (Index j = 0; j < targets.size(); ++j)
        if (NameOf(j) == wanted.parameter) targets[j] = wanted.sd / std::abs(known_.slopes[j]);
    return targets;
  }

  const std::string& NameOf(Index j) const {
    return plan_.vehicle.parameters[known_.places[static_cast<std::size_t>(j)]].name;
  }

  /// Repeats of all usual runs in turn, as long as the plan's time lasts.
  std::vector<int> EvenRepeats(const std::vector<PossibleRun>& possible) const {
    std::vector<int> repeats(possible.size());
    double left = plan_.design.cost_s * (1 + 1e-9);
    for (bool has_added = true; has_added;) {
      has_added = false;
      for (std::size_t c = 0; c < possible.size(); ++c) {
        if (!plan_.runs[c].run || !plan_.rig.runs[*plan_.runs[c].run].is_usual || possible[c].cost_s > left ||
            repeats[c] >= possible[c].most_repeats)
          continue;
        ++repeats[c];
        left -= possible[c].cost_s;
        has_added = true;
      }
    }
    return repeats;
  }

  void Describe(const std::vector<PossibleRun>& possible) {
    std::vector<int> all;
    for (const PossibleRun& one : possible) all.push_back(one.most_repeats);
    const auto deviations = [&](const Eigen::MatrixXd& covariance) -> Eigen::VectorXd {
      return covariance.diagonal().cwiseSqrt();
    };
    const Eigen::VectorXd before = deviations(InverseOf(known_.information));
    const Eigen::VectorXd after = deviations(plan_.design.covariance);
    const Eigen::VectorXd even = deviations(CovarianceWith(known_.information, possible, EvenRepeats(possible)));
    const Eigen::VectorXd best = deviations(CovarianceWith(known_.information, possible, all));
    plan_.gain_over_even = std::exp((even.array() / after.array()).log().mean());
    for (Index j = 0; j < after.size(); ++j) {
      const Parameter& parameter = plan_.vehicle.parameters[known_.places[static_cast<std::size_t>(j)]];
      const double slope = std::abs(known_.slopes[j]);
      PlannedParameter one{.name = parameter.name,
                           .unit = parameter.unit,
                           .value = parameter.value,
                           .before = slope * before[j],
                           .after = slope * after[j],
                           .even = slope * even[j],
                           .best = slope * best[j]};
      for (const WantedDeviation& wanted : plan_.rig.wanted)
        if (wanted.parameter == one.name) one.wanted = wanted.sd;
      if (one.wanted > 0 && one.after > one.wanted)
        plan_.findings.Report(kPlanWantMissed, {request_.rig.string()},
                              {'\'' + one.name + '\'', Rounded(plan_.rig.time_s / 60, 3) + " min",
                               InUnit(one.after, one.unit, 3) + ' ' + one.unit});
      plan_.parameters.push_back(std::move(one));
    }
  }

  const PlanRequest& request_;
  const WorkHooks& hooks_;
  KnownParameters known_;
  Plan plan_;
};

}  // namespace

Plan MakePlan(const PlanRequest& request, const WorkHooks& hooks) { return Planner(request, hooks).Run(); }

}  // namespace fourpost
