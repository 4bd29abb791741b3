#include "identify/fit/certainty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "analysis/numerics/decompositions.h"
#include "identify/fit/calibration_changes.h"
#include "identify/fit/input_noise.h"
#include "identify/refine/difference_jacobian.h"
#include "identify/refine/fit_variables.h"
#include "identify/uncertainty/residual_noise.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// What was fitted, in terms of one optimum.
class Optimum {
 public:
  Optimum(const VehicleObjective& objective, const Lattice& lattice, const RefineResult& best, const RobustLoss& loss,
          const Eigen::MatrixXd& input_noise)
      : data_(best.jacobian.rows() - objective.prior_count()),
        jacobian_(best.jacobian.topRows(data_)),
        priors_(best.jacobian.bottomRows(objective.prior_count())),
        residuals_(best.residuals.head(data_)),
        prior_residuals_(best.residuals.tail(objective.prior_count())),
        weights_(loss.OfData().Weights(residuals_)),
        curvatures_(loss.OfData().Curvatures(residuals_)),
        slopes_(FitVariables(lattice).Slopes(best.values)),
        structure_(JoinedStructure(objective.blocks())),
        // With a loss the cost is that of squares that would leave the same variance, but never less than the squares
        // are: a loss bounds the pull of residuals, and knows nothing of why they are so large.
        cost_(std::max(residuals_.squaredNorm(), loss.OfData().EquivalentCost(residuals_))),
        input_noise_(input_noise),
        noise_(residuals_.cwiseProduct(weights_), structure_, jacobian_) {
    const FitVariables variables(lattice);
    for (Index j = 0; j < variables.size(); ++j) is_relative_.push_back(variables.is_logarithmic(j));
  }

  Covariance NoiseCovariance(const std::vector<Index>& held) const {
    CovarianceOptions options;
    options.held = held;
    Covariance covariance = EstimateCovariance(jacobian_, slopes_, cost_, options, priors_);
    if (noise_.HasTime()) UseScoreCovariance(Hessian(curvatures_), Score(), slopes_, covariance);
    return covariance;
  }

  ModelErrorEstimate ModelError(const std::vector<Index>& judged) const {
    const Eigen::MatrixXd jacobian = jacobian_(Eigen::all, judged);
    Eigen::MatrixXd scores = residuals_.cwiseProduct(weights_).asDiagonal() * jacobian;
    Eigen::MatrixXd input_noise;
    if (input_noise_.size() > 0) input_noise = input_noise_(Eigen::all, judged);
    if (input_noise.size() > 0) scores -= input_noise;
    std::vector<bool> is_relative;
    for (const Index j : judged) is_relative.push_back(is_relative_[static_cast<std::size_t>(j)]);
    return EstimateModelError({.jacobian = jacobian,
                               .priors = priors_(Eigen::all, judged),
                               .scores = std::move(scores),
                               .input_noise = std::move(input_noise),
                               .weights = weights_,
                               .is_relative = std::move(is_relative)},
                              structure_, noise_);
  }

  /// What one standard deviation of each held parameter changes in the data's residuals.
  Eigen::MatrixXd ByHeld(const HeldParameters& held) const {
    return held.jacobian.topRows(data_) * held.variable_sd.asDiagonal();
  }

  /// judged x causes: by what the judged parameters give way to changes of the data's residuals.
  Eigen::MatrixXd MovedBy(const Eigen::MatrixXd& changes, const std::vector<Index>& judged) const {
    const Eigen::MatrixXd hessian = Hessian(weights_)(judged, judged);
    const Eigen::MatrixXd pull = jacobian_(Eigen::all, judged).transpose() * weights_.asDiagonal() * changes;
    return LeastNorm(hessian).Solve(pull);
  }

  /// What the data say of unknowns of unit variance that change the residuals, the judged parameters following:
  /// q = K u + e with K = (G - J D)'W (G - J D) + D'R'R D, D what the parameters give way by, e of the noise's
  /// covariance V, and the pull
  ///   q = -(G - J D)'W r + D' R' p + n
  /// with the priors' derivatives R and residuals p: -G'W r at the optimum, beside which noise of inputs may have moved
  /// the parameters; n is what that noise adds to the gradients by u and, through D, by the parameters, and its scatter
  /// is part of V. `input_noise`: of the former, N x causes; empty: nothing. With the unit variance of u
  ///   E u = P K' V^-1 q,  P = (1 + K' V^-1 K)^-1 its covariance.
  Calibrated Calibrate(const Eigen::MatrixXd& changes, const Eigen::MatrixXd& input_noise,
                       const std::vector<Index>& judged) const {
    const Eigen::MatrixXd moved = MovedBy(changes, judged);
    Eigen::MatrixXd left = changes - jacobian_(Eigen::all, judged) * moved;
    const std::vector<Index> unseen = UnseenOf(changes, left);
    left(Eigen::all, unseen).setZero();
    const Eigen::MatrixXd through_priors = priors_(Eigen::all, judged) * moved;
    const Eigen::MatrixXd by_priors = through_priors.transpose() * through_priors;
    const Eigen::MatrixXd curvature = left.transpose() * weights_.asDiagonal() * left + by_priors;
    Eigen::VectorXd pull =
        through_priors.transpose() * prior_residuals_ - left.transpose() * weights_.cwiseProduct(residuals_);
    Eigen::MatrixXd noise = ScoreOf(left) + by_priors;
    if (input_noise_.size() > 0 && input_noise.size() > 0) {
      Eigen::MatrixXd added = input_noise - input_noise_(Eigen::all, judged) * moved;
      added(Eigen::all, unseen).setZero();
      pull += added.colwise().sum().transpose();
      noise += noise_.CovarianceOfStretches(added, noise_.over_time());
    }
    // Unknowns that nothing shows have neither curvature nor noise.
    constexpr double kFloor = 1e-12;
    noise.diagonal().array() += kFloor * std::max(1.0, noise.diagonal().maxCoeff());
    const Eigen::LDLT<Eigen::MatrixXd> weighed(noise);
    const Eigen::MatrixXd information = curvature.transpose() * weighed.solve(curvature);
    Calibrated found{.changes = changes, .mean = {}, .covariance = {}, .step = Eigen::VectorXd::Zero(jacobian_.cols())};
    found.covariance = (Eigen::MatrixXd::Identity(information.rows(), information.cols()) + information).inverse();
    found.mean = found.covariance * curvature.transpose() * weighed.solve(pull);
    found.step(judged) = -moved * found.mean;
    return found;
  }

 private:
  Eigen::MatrixXd Hessian(const Eigen::VectorXd& weights) const {
    return jacobian_.transpose() * weights.asDiagonal() * jacobian_ + priors_.transpose() * priors_;
  }

  /// Places of causes whose changes the parameters take up but for what derivatives are off by.
  std::vector<Index> UnseenOf(const Eigen::MatrixXd& changes, const Eigen::MatrixXd& left) const {
    constexpr double kDerivatives = 0.01;
    std::vector<Index> unseen;
    const Eigen::VectorXd roots = weights_.cwiseSqrt();
    for (Index c = 0; c < changes.cols(); ++c)
      if (roots.cwiseProduct(left.col(c)).norm() < kDerivatives * roots.cwiseProduct(changes.col(c)).norm())
        unseen.push_back(c);
    return unseen;
  }

  /// Covariance of sum_i G_i r_i of the noise, N x causes: over time by the residuals' own correlation; else by their
  /// stated deviations, larger where the residuals are.
  Eigen::MatrixXd ScoreOf(const Eigen::MatrixXd& changes) const {
    const Eigen::VectorXd gradient = residuals_.cwiseProduct(weights_);
    double squares = 0;
    double count = 0;
    Eigen::MatrixXd others = Eigen::MatrixXd::Zero(changes.cols(), changes.cols());
    for (Index i = 0; i < data_; ++i) {
      if (noise_.over_time()[static_cast<std::size_t>(i)]) continue;
      squares += gradient[i] * gradient[i];
      count += 1;
      others += changes.row(i).transpose() * changes.row(i);
    }
    const double inflation = count > static_cast<double>(jacobian_.cols()) ? std::max(1.0, squares / count) : 1;
    if (!noise_.HasTime()) return inflation * others;
    return noise_.CovarianceOverTime(changes) + inflation * others;
  }

  Eigen::MatrixXd Score() const {
    Eigen::MatrixXd score = ScoreOf(jacobian_) + priors_.transpose() * priors_;
    // The noise that was added once more to take back a bias scatters, too.
    if (input_noise_.size() == 0) return score;
    score += noise_.CovarianceOfStretches(input_noise_, noise_.over_time());
    // Nor is its power known better, of some thirty segments of a record and a few frequencies in each.
    constexpr double kPower = 0.1;
    const Eigen::VectorXd taken = kPower * input_noise_.colwise().sum();
    return score + taken * taken.transpose();
  }

  Index data_;
  Eigen::MatrixXd jacobian_;
  Eigen::MatrixXd priors_;
  Eigen::VectorXd residuals_;
  Eigen::VectorXd prior_residuals_;
  Eigen::VectorXd weights_;
  Eigen::VectorXd curvatures_;
  Eigen::VectorXd slopes_;
  ResidualStructure structure_;
  double cost_;
  Eigen::MatrixXd input_noise_;
  ResidualNoise noise_;
  std::vector<bool> is_relative_;
};

/// In the unit of FitVariables.
double DeviationOf(const Parameter& parameter, const FitVariables& variables, Index j) {
  const double range = variables.upper()[j] - variables.lower()[j];
  if (!parameter.prior_sd) return range / std::sqrt(12.0);
  return variables.is_logarithmic(j) ? *parameter.prior_sd / parameter.value
                                     : *parameter.prior_sd / (parameter.upper - parameter.lower);
}

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

std::vector<std::size_t> PlacesHeld(const VehicleObjective& objective) {
  std::vector<std::size_t> places;
  const std::vector<std::size_t>& free = objective.free();
  for (std::size_t i = 0; i < objective.vehicle().parameters.size(); ++i) {
    const Parameter& parameter = objective.vehicle().parameters[i];
    const bool is_free = std::find(free.begin(), free.end(), i) != free.end();
    const bool is_inside = parameter.lower <= parameter.value && parameter.value <= parameter.upper;
    if (!is_free && parameter.lower < parameter.upper && is_inside) places.push_back(i);
  }
  return places;
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

/// At the file's values; nothing where it cannot be evaluated or the user stops it.
std::optional<Eigen::MatrixXd> JacobianOf(const VehicleObjective& objective, const RefineOptions& refine, int threads,
                                          const std::function<bool()>& stop, std::int64_t& evaluated) {
  if (objective.free().empty() || stop()) return std::nullopt;
  Archive archive(objective.MakeProblem(), threads);
  archive.StopBatches(stop);
  const FitVariables variables(archive.lattice());
  std::optional<Eigen::MatrixXd> jacobian;
  try {
    const Eigen::VectorXd at = objective.FileValues();
    const Evaluation here = archive.EvaluateValues({at}).front();
    if (here.ok())
      jacobian = DifferenceJacobian(archive, variables, variables.FromValues(at), here.residuals,
                                    refine.DifferenceStep(archive.problem()), Differences::kAutomatic);
  } catch (const BatchStopped&) {
  }
  evaluated += archive.counts().paid;
  return jacobian;
}

}  // namespace

HeldParameters HeldAt(const VehicleObjective& objective, const Eigen::VectorXd& values, const RefineOptions& refine,
                      int threads, const std::function<bool()>& stop, std::int64_t& evaluated) {
  const std::vector<std::size_t> places = PlacesHeld(objective);
  Vehicle fitted = objective.vehicle();
  const std::vector<double> all = objective.AllParameters(values);
  for (std::size_t i = 0; i < all.size(); ++i) fitted.parameters[i].value = all[i];
  for (Parameter& parameter : fitted.parameters) parameter.prior_sd.reset();
  const auto of = [&](const std::vector<std::size_t>& some) {
    return JacobianOf(VehicleObjective(fitted, some, objective.blocks()), refine, threads, stop, evaluated);
  };
  HeldParameters held;
  const auto add = [&](const std::vector<std::size_t>& some, const Eigen::MatrixXd& jacobian) {
    held.places.insert(held.places.end(), some.begin(), some.end());
    held.jacobian.conservativeResize(jacobian.rows(), held.jacobian.cols() + jacobian.cols());
    held.jacobian.rightCols(jacobian.cols()) = jacobian;
  };
  if (const std::optional<Eigen::MatrixXd> together = of(places)) {
    add(places, *together);
  } else {
    for (const std::size_t place : places)
      if (const std::optional<Eigen::MatrixXd> alone = of({place})) add({place}, *alone);
  }
  if (held.places.empty()) return {};
  const FitVariables variables(VehicleObjective(fitted, held.places, objective.blocks()).MakeProblem().lattice);
  held.variable_sd.resize(std::ssize(held.places));
  for (Index i = 0; i < held.variable_sd.size(); ++i)
    held.variable_sd[i] =
        DeviationOf(objective.vehicle().parameters[held.places[static_cast<std::size_t>(i)]], variables, i);
  return held;
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
    const double noise = certainty.noise_sd[j];
    const double disagreement =
        certainty.model_error.is_significant ? certainty.model_error.reach[row] / certainty.covariance.reach_95 : 0;
    certainty.model_sd[j] = disagreement;
    certainty.held_sd[j] = std::min(certainty.held_sd[j], known[j]);
    certainty.model_sd[j] = std::min(certainty.model_sd[j], known[j]);
    certainty.total_sd[j] = std::hypot(noise, certainty.held_sd[j], certainty.model_sd[j]);
  }
  AddCovariances(of_held, certainty);
  return certainty;
}

ModelErrorEstimate ModelErrorLeft(const VehicleObjective& objective, const Lattice& lattice,
                                  const RefineResult& explained, const RobustLoss& loss,
                                  const std::vector<Index>& judged) {
  return Optimum(objective, lattice, explained, loss, {}).ModelError(judged);
}

}  // namespace fourpost
