#include "identify/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <system_error>

#include <Eigen/Cholesky>

#include "analysis/files/text_file.h"
#include "analysis/text/text_table.h"
#include "identify/experiments/fit_balance.h"
#include "identify/plan/findings.h"
#include "identify/plan/recorded_noise.h"
#include "identify/refine/fit_variables.h"
#include "identify/run/run_spread.h"
#include "identify/search/parallel.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/response/balance_sensitivity.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// The parameters to determine, in FitVariables: ln of the value, or a share of the range.
struct Determined {
  std::vector<std::size_t> places;
  /// d value [SI] / d variable.
  Eigen::VectorXd slopes;
  /// Inverse covariance before anything is measured.
  Eigen::MatrixXd known;
};

Eigen::MatrixXd InverseOf(const Eigen::MatrixXd& matrix) {
  return matrix.ldlt().solve(Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
}

std::size_t PlaceOf(const Vehicle& vehicle, const std::string& name) {
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i)
    if (vehicle.parameters[i].name == name) return i;
  throw std::logic_error("plan: no parameter " + name);
}

/// Of a fit: those that have a standard deviation, as its noise allows.
Determined OfRun(const std::filesystem::path& run, const Vehicle& vehicle) {
  const ParameterSpread spread = ReadRunSpread(run).parameters;
  Determined determined;
  const Eigen::VectorXd slopes = FitVariables(spread.lattice).Slopes(spread.values);
  determined.slopes = slopes(spread.judged);
  for (const Index j : spread.judged)
    determined.places.push_back(PlaceOf(vehicle, spread.lattice.axes()[static_cast<std::size_t>(j)].name));
  determined.known = InverseOf(spread.noise);
  return determined;
}

/// Of a vehicle file: all with a range, which count as anywhere in it, or as their priors say.
Determined OfVehicle(const Vehicle& vehicle) {
  Determined determined;
  std::vector<double> slopes;
  std::vector<double> known;
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) {
    const Parameter& parameter = vehicle.parameters[i];
    if (!(parameter.upper > parameter.lower)) continue;
    const double slope = parameter.lower > 0 ? parameter.value : parameter.upper - parameter.lower;
    const double width = parameter.lower > 0 ? std::log(parameter.upper / parameter.lower) : 1;
    double variance = width * width / 12;
    if (parameter.prior_sd) variance = std::min(variance, std::pow(*parameter.prior_sd / slope, 2));
    determined.places.push_back(i);
    slopes.push_back(slope);
    known.push_back(1 / variance);
  }
  determined.slopes = Eigen::Map<const Eigen::VectorXd>(slopes.data(), std::ssize(slopes));
  determined.known = Eigen::Map<const Eigen::VectorXd>(known.data(), std::ssize(known)).asDiagonal();
  return determined;
}

/// A run's answer and its derivatives at the present values.
struct AnsweredRun {
  ResponseSensitivity sensitivity;
  std::vector<double> amplitude_m;
  std::string failure;
};

AnsweredRun Answer(const CondensedVehicle& car, const std::vector<double>& values, const Determined& determined,
                   const RigRun& run) {
  AnsweredRun answer;
  for (const double frequency : run.frequency_Hz) answer.amplitude_m.push_back(run.amplitude.At(frequency));
  try {
    answer.sensitivity = SolveBalanceSensitivity(car, values, determined.places,
                                                 {run.frequency_Hz, answer.amplitude_m, run.shape}, kFitBalance);
    if (!answer.sensitivity.periodic.unconverged_Hz.empty())
      answer.failure =
          "the car has no steady motion at " + Rounded(answer.sensitivity.periodic.unconverged_Hz.front(), 3) + " Hz";
  } catch (const std::runtime_error& error) {
    answer.failure = error.what();
  } catch (const std::invalid_argument& error) {
    answer.failure = error.what();
  }
  return answer;
}

/// Largest amplitude of each sensor in all runs, in its unit.
Eigen::VectorXd LargestAmplitudes(const Vehicle& vehicle, const RigFile& rig, const std::vector<AnsweredRun>& answers) {
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(static_cast<Index>(vehicle.sensors.size()));
  for (std::size_t r = 0; r < answers.size(); ++r) {
    if (!answers[r].failure.empty()) continue;
    const FrequencyResponse& response = answers[r].sensitivity.periodic.response;
    for (std::size_t s = 0; s < vehicle.sensors.size(); ++s)
      for (std::size_t f = 0; f < response.frequency_Hz.size(); ++f) {
        const double reference =
            ReferenceOf(vehicle.sensors[s].type, rig.runs[r].frequency_Hz[f], answers[r].amplitude_m[f]);
        double& most = largest[static_cast<Index>(s)];
        most = std::max(most, std::abs(response.channels[s].response[f]) * reference);
      }
  }
  return largest;
}

/// Rows of what is read: along and across each phasor, and mean offsets of struts.
PossibleRun ReadingsOf(const Vehicle& vehicle, const RigFile& rig, const RigRun& run, const AnsweredRun& answer,
                       const Determined& determined) {
  const ResponseSensitivity& sensitivity = answer.sensitivity;
  const auto p = static_cast<Index>(determined.places.size());
  std::vector<Eigen::RowVectorXd> rows;
  std::vector<double> noise;
  std::vector<double> floor;
  const auto add = [&](Eigen::RowVectorXd row, double sd, double error) {
    rows.push_back(row.cwiseProduct(determined.slopes.transpose()));
    noise.push_back(sd * sd);
    floor.push_back(error * error);
  };
  for (std::size_t s = 0; s < vehicle.sensors.size(); ++s) {
    if (!rig.is_read[s]) continue;
    const ChannelResponse& channel = sensitivity.periodic.response.channels[s];
    for (std::size_t f = 0; f < channel.response.size(); ++f) {
      const std::complex<double> phasor = channel.response[f];
      const double gain = std::abs(phasor);
      if (!(gain > 0)) continue;
      const double reference = ReferenceOf(vehicle.sensors[s].type, run.frequency_Hz[f], answer.amplitude_m[f]);
      const double sd = rig.noise[s] / reference;
      Eigen::RowVectorXd along(p);
      Eigen::RowVectorXd across(p);
      for (Index j = 0; j < p; ++j) {
        const ChannelResponse& slope = sensitivity.by_parameter[static_cast<std::size_t>(j)].channels[s];
        const std::complex<double> turned = slope.response[f] * std::conj(phasor) / gain;
        along[j] = turned.real();
        across[j] = turned.imag();
      }
      add(std::move(along), sd, gain * rig.gain_error);
      add(std::move(across), sd, gain * rig.phase_error_rad);
      if (vehicle.sensors[s].type != Sensor::Type::kStrut || channel.mean.empty()) continue;
      Eigen::RowVectorXd mean(p);
      for (Index j = 0; j < p; ++j) mean[j] = sensitivity.by_parameter[static_cast<std::size_t>(j)].channels[s].mean[f];
      add(std::move(mean), rig.noise[s], rig.mean_error_m);
    }
  }
  PossibleRun possible{.cost_s = rig.TimeOf(run), .most_repeats = rig.most_repeats};
  possible.slopes.resize(std::ssize(rows), p);
  for (std::size_t i = 0; i < rows.size(); ++i) possible.slopes.row(static_cast<Index>(i)) = rows[i];
  possible.noise = Eigen::Map<const Eigen::VectorXd>(noise.data(), std::ssize(noise));
  possible.floor = Eigen::Map<const Eigen::VectorXd>(floor.data(), std::ssize(floor));
  return possible;
}

PossibleRun ReadingsOf(const DirectMeasurement& measurement, const Vehicle& vehicle, const Determined& determined) {
  const auto p = static_cast<Index>(determined.places.size());
  PossibleRun possible{.cost_s = measurement.time_s, .most_repeats = 1};
  possible.slopes = Eigen::RowVectorXd::Zero(p);
  for (Index j = 0; j < p; ++j)
    if (vehicle.parameters[determined.places[static_cast<std::size_t>(j)]].name == measurement.parameter)
      possible.slopes(0, j) = determined.slopes[j];
  possible.noise = Eigen::VectorXd::Constant(1, measurement.sd * measurement.sd);
  possible.floor = Eigen::VectorXd::Zero(1);
  return possible;
}

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
    plan_.design = BestDesign(determined_.known, possible, goal);
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
    determined_ = is_run ? OfRun(request_.run, plan_.vehicle) : OfVehicle(plan_.vehicle);
    if (determined_.places.empty()) Refuse(kPlanWithoutParameters, place, {});
    plan_.rig = UsualRig(plan_.vehicle);
    if (!request_.rig.empty()) {
      const std::optional<std::string> text = ReadTextFile(request_.rig, faults);
      std::optional<RigFile> rig;
      if (text) rig = ReadRigText(*text, request_.rig, plan_.vehicle, determined_.places, faults);
      if (!rig) throw FaultyInput(faults);
      plan_.rig = *std::move(rig);
    }
    plan_.findings.Add(faults);
    if (is_run) TakeRecordedNoise();
    if (request_.time_s) plan_.rig.time_s = *request_.time_s;
  }

  std::vector<PossibleRun> PossibleRuns() {
    const CondensedVehicle car(plan_.vehicle);
    const std::vector<double> values = plan_.vehicle.ParameterValues();
    const RigFile& rig = plan_.rig;
    std::vector<AnsweredRun> answers(rig.runs.size());
    std::mutex shown;
    std::size_t done = 0;
    ForEachInParallel(rig.runs.size(), ThreadCount(request_.threads), [&](std::size_t r) {
      if (hooks_.IsStopped()) return;
      answers[r] = Answer(car, values, determined_, rig.runs[r]);
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
      possible.push_back(ReadingsOf(plan_.vehicle, rig, rig.runs[r], answers[r], determined_));
      plan_.runs.push_back({.name = rig.runs[r].name, .time_s = possible.back().cost_s, .run = r});
    }
    for (const DirectMeasurement& measurement : rig.measurements) {
      possible.push_back(ReadingsOf(measurement, plan_.vehicle, determined_));
      plan_.runs.push_back({.name = measurement.name, .time_s = measurement.time_s});
    }
    return possible;
  }

  /// Where none is stated. Sensors that the fit's recordings do not have are not there, unless the rig's file says so.
  void TakeRecordedNoise() {
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
        most = std::max(most, turning * ReferenceOf(type, frequency, amplitude));
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
    Eigen::VectorXd targets =
        Eigen::VectorXd::Constant(determined_.slopes.size(), std::numeric_limits<double>::infinity());
    for (const WantedDeviation& wanted : plan_.rig.wanted)
      for (Index j = 0; j < targets.size(); ++j)
        if (NameOf(j) == wanted.parameter) targets[j] = wanted.sd / std::abs(determined_.slopes[j]);
    return targets;
  }

  const std::string& NameOf(Index j) const {
    return plan_.vehicle.parameters[determined_.places[static_cast<std::size_t>(j)]].name;
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
    const Eigen::VectorXd before = deviations(InverseOf(determined_.known));
    const Eigen::VectorXd after = deviations(plan_.design.covariance);
    const Eigen::VectorXd even = deviations(CovarianceWith(determined_.known, possible, EvenRepeats(possible)));
    const Eigen::VectorXd best = deviations(CovarianceWith(determined_.known, possible, all));
    plan_.gain_over_even = std::exp((even.array() / after.array()).log().mean());
    for (Index j = 0; j < after.size(); ++j) {
      const Parameter& parameter = plan_.vehicle.parameters[determined_.places[static_cast<std::size_t>(j)]];
      const double slope = std::abs(determined_.slopes[j]);
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
  Determined determined_;
  Plan plan_;
};

}  // namespace

Plan MakePlan(const PlanRequest& request, const WorkHooks& hooks) { return Planner(request, hooks).Run(); }

}  // namespace fourpost
