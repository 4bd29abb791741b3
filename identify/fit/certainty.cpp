#include "identify/fit/certainty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "identify/fit/calibration_changes.h"
#include "identify/fit/input_noise.h"
#include "identify/refine/fit_variables.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Of the free parameters, in FitVariables; infinite without a prior.
Eigen::VectorXd PriorDeviations(const VehicleObjective& objective, const Lattice& lattice,
                                const Eigen::VectorXd& values) {
  const Eigen::VectorXd slopes = FitVariables(lattice).Slopes(values);
  Eigen::VectorXd deviations = Eigen::VectorXd::Constant(slopes.size(), std::numeric_limits<double>::infinity());
  for (Index j = 0; j < slopes.size(); ++j)
    if (const auto& sd = objective.vehicle().parameters[objective.free()[static_cast<std::size_t>(j)]].prior_sd)
      deviations[j] = *sd / slopes[j];
  return deviations;
}

/// A model's error moves a parameter no farther from another one that it is like than their ratio may be off. Both are
/// logarithms in FitVariables.
void LimitByRatios(const VehicleObjective& objective, const std::vector<Index>& judged, Eigen::VectorXd& model_sd) {
  // Nothing is known of those that are not judged.
  Eigen::VectorXd moved = Eigen::VectorXd::Constant(model_sd.size(), std::numeric_limits<double>::infinity());
  moved(judged) = model_sd(judged);
  const std::vector<std::size_t>& free = objective.free();
  const Vehicle& vehicle = objective.vehicle();
  const auto limit = [&](std::size_t one, std::size_t other, double sd) {
    const auto at = std::find(free.begin(), free.end(), one);
    if (at == free.end()) return;
    const auto beside = std::find(free.begin(), free.end(), other);
    const double of_other = beside == free.end() ? 0 : moved[beside - free.begin()];
    moved[at - free.begin()] = std::min(moved[at - free.begin()], std::hypot(of_other, sd));
  };
  // Along chains of any length.
  for (std::size_t pass = 0; pass < free.size(); ++pass)
    for (std::size_t i = 0; i < vehicle.parameters.size(); ++i)
      if (const auto& like = vehicle.parameters[i].like)
        if (const auto other = vehicle.IndexOf(like->parameter)) {
          limit(i, *other, like->sd);
          limit(*other, i, like->sd);
        }
  model_sd(judged) = moved(judged);
}

/// The covariance with other deviations, its correlations as they are.
Eigen::MatrixXd WithDeviations(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& sd) {
  Eigen::VectorXd factors = sd;
  for (Index j = 0; j < sd.size(); ++j) factors[j] = covariance(j, j) > 0 ? sd[j] / std::sqrt(covariance(j, j)) : 0;
  return factors.asDiagonal() * covariance * factors.asDiagonal();
}

/// Parts of independent causes add up. `of_held`: judged x judged, before it is limited by priors.
void AddCovariances(const Eigen::MatrixXd& of_held, Certainty& certainty) {
  const std::vector<Index>& judged = certainty.judged;
  const Eigen::MatrixXd correlations = Correlations(certainty.covariance)(judged, judged);
  certainty.noise_covariance = WithDeviations(correlations, certainty.noise_sd(judged));
  certainty.total_covariance = certainty.noise_covariance + WithDeviations(of_held, certainty.held_sd(judged)) +
                               WithDeviations(certainty.model_error.covariance, certainty.model_sd(judged));
}

}  // namespace

bool IsAtBound(const LatticeAxis& axis, double value) {
  constexpr double kAtBound = 1e-6;
  const double near = kAtBound * (axis.upper - axis.lower);
  return value - axis.lower < near || axis.upper - value < near;
}

std::vector<ParameterState> StatesAt(const RefineResult& best, const Lattice& lattice,
                                     const std::vector<Index>& noisy) {
  std::vector<ParameterState> states(lattice.size(), ParameterState::kDetermined);
  const Eigen::VectorXd norms = best.jacobian.colwise().norm();
  Eigen::VectorXd sound = norms;
  for (const Index j : noisy) {
    states[static_cast<std::size_t>(j)] = ParameterState::kNoise;
    sound[j] = 0;
  }
  const double least = CovarianceOptions().rank_threshold * sound.maxCoeff();
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    const auto j = static_cast<Index>(i);
    if (IsAtBound(lattice.axes()[i], best.values[j]) && norms[j] > least) states[i] = ParameterState::kAtBound;
  }
  return states;
}

std::vector<Index> FixedOf(const std::vector<ParameterState>& states) {
  std::vector<Index> fixed;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (states[i] != ParameterState::kDetermined) fixed.push_back(static_cast<Index>(i));
  return fixed;
}

namespace {

/// The part of the data whose absence moves a judged parameter most.
std::string LoudestPart(const ModelErrorEstimate& estimate, Index judged) {
  std::string name;
  double largest = 0;
  for (const PartedData& way : estimate.ways)
    for (Index g = 0; g < way.shifts.cols(); ++g)
      if (const double beyond = std::abs(way.shifts(judged, g)) - way.by_noise(judged, g); beyond > largest) {
        largest = beyond;
        name = way.clusters[static_cast<std::size_t>(g)];
      }
  return name;
}

}  // namespace

Eigen::VectorXd Certainty::MovedByMissing() const {
  if (missing.empty()) return Eigen::VectorXd::Zero(total_sd.size());
  return by_missing.rowwise().sum();
}

double Certainty::SdAboutEnds(Index parameter) const {
  const double moved = MovedByMissing()[parameter];
  const double variance = total_sd[parameter] * total_sd[parameter] - moved * moved / 3;
  return variance < 0 ? 0 : std::sqrt(variance);  // NaN of one without a deviation
}

double Certainty::HalfWidth(Index parameter) const {
  return covariance.reach_95 * SdAboutEnds(parameter) + std::abs(MovedByMissing()[parameter]) / 2;
}

void Certainty::AllowForMissing(std::vector<std::string> names, Eigen::MatrixXd moved, const ModelErrorEstimate& left) {
  // Where the residuals that are left determine a parameter no more, nothing is known of it.
  if (!moved.allFinite() || !left.covariance.allFinite()) return;
  missing = std::move(names);
  by_missing = std::move(moved);
  // Second moment about one end of what is uniform between both.
  const Eigen::VectorXd uniform = MovedByMissing() / std::sqrt(3.0);
  // What all parts of the data have in common is now known.
  const Eigen::MatrixXd whole = WithDeviations(model_error.covariance, model_sd(judged));
  const Eigen::VectorXd before = model_sd(judged) / kErrorInCommon;
  Eigen::VectorXd after(std::ssize(judged));
  for (Index row = 0; row < after.size(); ++row) {
    const Index j = judged[static_cast<std::size_t>(row)];
    const double reach = left.is_significant ? left.reach[row] / covariance.reach_95 / kErrorInCommon : 0;
    after[row] = std::min(before[row], reach);
    // With even odds the additions are the physics, or look like it.
    model_sd[j] = std::sqrt((before[row] * before[row] + after[row] * after[row]) / 2 + uniform[j] * uniform[j]);
    total_sd[j] = std::hypot(noise_sd[j], held_sd[j], model_sd[j]);
  }
  total_covariance += (WithDeviations(model_error.covariance, before) + WithDeviations(left.covariance, after)) / 2 -
                      whole + uniform(judged) * uniform(judged).transpose();
}

std::string Certainty::LimitedBy(Index parameter) const {
  const auto place = std::find(judged.begin(), judged.end(), parameter);
  if (place == judged.end()) return "";
  const double noise = noise_sd[parameter];
  if (model_sd[parameter] > std::max(noise, held_sd[parameter])) {
    if (2 * std::pow(MovedByMissing()[parameter], 2) / 3 > std::pow(model_sd[parameter], 2)) {
      Index largest = 0;
      by_missing.row(parameter).cwiseAbs().maxCoeff(&largest);
      return "missing: " + missing[static_cast<std::size_t>(largest)];
    }
    return "model: " + LoudestPart(model_error, place - judged.begin());
  }
  if (held_sd[parameter] <= noise) return "noise";
  Index largest = 0;
  by_held.col(parameter).maxCoeff(&largest);
  const bool is_parameter = static_cast<std::size_t>(largest) + calibrations.size() < held.size();
  return (is_parameter ? "held: " : "calibration: ") + held[static_cast<std::size_t>(largest)];
}

std::vector<Contradiction> Certainty::Contradictions() const {
  std::vector<Contradiction> found =
      model_error.by_recording.Contradictions(covariance.reach_95 * Eigen::VectorXd(noise_sd(judged)));
  for (Contradiction& one : found) one.parameter = judged[static_cast<std::size_t>(one.parameter)];
  return found;
}

namespace {

std::vector<CalibrationEstimate> Estimates(const Calibrated& calibrated, const std::vector<Calibration>& calibrations) {
  std::vector<CalibrationEstimate> estimates;
  for (std::size_t i = 0; i < calibrations.size(); ++i) {
    const auto c = static_cast<Index>(i);
    const Calibration& one = calibrations[i];
    const double variance = calibrated.covariance(c, c);
    // Before the data are seen the mean is of variance 1 - P.
    constexpr double kUnseen = 1e-9;
    estimates.push_back({.name = one.Name(),
                         .unit = one.Unit(),
                         .sd = one.sd,
                         .estimate = one.sd * calibrated.mean[c],
                         .estimate_sd = one.sd * std::sqrt(variance),
                         .surprise = 1 - variance > kUnseen ? calibrated.mean[c] / std::sqrt(1 - variance) : 0});
  }
  return estimates;
}

}  // namespace

std::optional<Calibrated> CalibratedAt(const VehicleObjective& objective, const Lattice& lattice,
                                       const RefineResult& best, const RobustLoss& loss,
                                       const std::vector<ParameterState>& states, const InputNoise& noise) {
  if (objective.calibrations().empty()) return std::nullopt;
  const Eigen::MatrixXd changes = CalibrationChanges(objective, best.values);
  if (changes.cols() == 0) return std::nullopt;
  std::vector<Index> judged;
  for (std::size_t j = 0; j < states.size(); ++j)
    if (states[j] == ParameterState::kDetermined) judged.push_back(static_cast<Index>(j));
  return Optimum(objective, lattice, best, loss, noise.gradient).Calibrate(changes, noise.of_calibrations, judged);
}

Certainty CertaintyAt(const VehicleObjective& objective, const Lattice& lattice, const RefineResult& best,
                      const RobustLoss& loss, const std::vector<ParameterState>& states,
                      const Eigen::MatrixXd& input_noise, const HeldParameters& held,
                      const std::optional<Calibrated>& calibrated) {
  const Optimum optimum(objective, lattice, best, loss, input_noise);
  Certainty certainty;
  certainty.states = states;
  certainty.covariance = optimum.NoiseCovariance(FixedOf(states));
  certainty.noise_sd = certainty.covariance.variable_sd;
  const auto count = static_cast<Index>(lattice.size());
  for (Index j = 0; j < count; ++j) {
    if (std::isinf(certainty.noise_sd[j]))
      certainty.states[static_cast<std::size_t>(j)] = ParameterState::kUndetermined;
    if (std::isfinite(certainty.noise_sd[j])) certainty.judged.push_back(j);
  }
  certainty.held_sd = certainty.model_sd = Eigen::VectorXd::Zero(count);
  certainty.total_sd = certainty.noise_sd;
  for (const std::size_t place : held.left_out)
    certainty.held_left_out.push_back(objective.vehicle().parameters[place].name);
  if (certainty.judged.empty()) return certainty;

  certainty.model_error = optimum.ModelError(certainty.judged);
  Eigen::MatrixXd by_held = Eigen::MatrixXd::Zero(std::ssize(certainty.judged), std::ssize(held.places));
  if (!held.places.empty()) by_held = optimum.MovedBy(optimum.ByHeld(held), certainty.judged);
  for (const std::size_t place : held.places) certainty.held.push_back(objective.vehicle().parameters[place].name);
  Eigen::MatrixXd of_held = by_held * by_held.transpose();
  if (calibrated) {
    const Eigen::MatrixXd moved = optimum.MovedBy(calibrated->changes, certainty.judged);
    of_held += moved * calibrated->covariance * moved.transpose();
    by_held.conservativeResize(Eigen::NoChange, by_held.cols() + moved.cols());
    by_held.rightCols(moved.cols()) = moved * calibrated->covariance.diagonal().cwiseSqrt().asDiagonal();
    certainty.calibrations = Estimates(*calibrated, objective.calibrations());
    for (const CalibrationEstimate& one : certainty.calibrations) certainty.held.push_back(one.name);
  }
  certainty.by_held = Eigen::MatrixXd::Zero(by_held.cols(), count);
  const Eigen::VectorXd known = PriorDeviations(objective, lattice, best.values);
  for (std::size_t i = 0; i < certainty.judged.size(); ++i) {
    const auto row = static_cast<Index>(i);
    const Index j = certainty.judged[i];
    certainty.by_held.col(j) = by_held.row(row).transpose().cwiseAbs();
    certainty.held_sd[j] = std::sqrt(of_held(row, row));
    const double disagreement =
        certainty.model_error.is_significant ? certainty.model_error.reach[row] / certainty.covariance.reach_95 : 0;
    certainty.model_sd[j] = disagreement;
    certainty.held_sd[j] = std::min(certainty.held_sd[j], known[j]);
    certainty.model_sd[j] = std::min(certainty.model_sd[j], known[j]);
  }
  LimitByRatios(objective, certainty.judged, certainty.model_sd);
  for (const Index j : certainty.judged)
    certainty.total_sd[j] = std::hypot(certainty.noise_sd[j], certainty.held_sd[j], certainty.model_sd[j]);
  AddCovariances(of_held, certainty);
  return certainty;
}

ModelErrorEstimate ModelErrorLeft(const VehicleObjective& objective, const Lattice& lattice,
                                  const RefineResult& explained, const RobustLoss& loss,
                                  const std::vector<Index>& judged) {
  return Optimum(objective, lattice, explained, loss, {}).ModelError(judged);
}

}  // namespace fourpost
