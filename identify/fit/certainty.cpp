#include "identify/fit/certainty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/numerics/decompositions.h"
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
        weights_(loss.Weights(residuals_)),
        curvatures_(loss.Curvatures(residuals_)),
        slopes_(FitVariables(lattice).Slopes(best.values)),
        structure_(JoinedStructure(objective.blocks())),
        // With a loss the cost is that of squares that would leave the same variance, but never less than the squares
        // are: a loss bounds the pull of residuals, and knows nothing of why they are so large.
        cost_(std::max(residuals_.squaredNorm(), loss.EquivalentCost(residuals_))),
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

  /// judged x held: what one deviation of a held parameter moves the others by.
  Eigen::MatrixXd MovedBy(const HeldParameters& held, const std::vector<Index>& judged) const {
    const Eigen::MatrixXd hessian = Hessian(weights_)(judged, judged);
    const Eigen::MatrixXd pull = jacobian_(Eigen::all, judged).transpose() * weights_.asDiagonal() *
                                 held.jacobian.topRows(data_) * held.variable_sd.asDiagonal();
    return LeastNorm(hessian).Solve(pull);
  }

 private:
  Eigen::MatrixXd Hessian(const Eigen::VectorXd& weights) const {
    return jacobian_.transpose() * weights.asDiagonal() * jacobian_ + priors_.transpose() * priors_;
  }

  /// Over time by the residuals' own correlation; else by their stated deviations, larger where the residuals are.
  Eigen::MatrixXd Score() const {
    const Eigen::VectorXd gradient = residuals_.cwiseProduct(weights_);
    double squares = 0;
    double count = 0;
    Eigen::MatrixXd others = Eigen::MatrixXd::Zero(jacobian_.cols(), jacobian_.cols());
    for (Index i = 0; i < data_; ++i) {
      if (noise_.over_time()[static_cast<std::size_t>(i)]) continue;
      squares += gradient[i] * gradient[i];
      count += 1;
      others += jacobian_.row(i).transpose() * jacobian_.row(i);
    }
    const double inflation = count > static_cast<double>(jacobian_.cols()) ? std::max(1.0, squares / count) : 1;
    Eigen::MatrixXd score = noise_.CovarianceOverTime(jacobian_) + inflation * others + priors_.transpose() * priors_;
    // The noise that was added once more to take back a bias scatters, too.
    if (input_noise_.size() > 0) score += noise_.CovarianceOfStretches(input_noise_, noise_.over_time());
    return score;
  }

  Index data_;
  Eigen::MatrixXd jacobian_;
  Eigen::MatrixXd priors_;
  Eigen::VectorXd residuals_;
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

std::string Certainty::LimitedBy(Index parameter) const {
  const auto place = std::find(judged.begin(), judged.end(), parameter);
  if (place == judged.end()) return "";
  const double noise = noise_sd[parameter];
  if (model_sd[parameter] > std::max(noise, held_sd[parameter]))
    return "model: " + LoudestPart(model_error, place - judged.begin());
  if (held_sd[parameter] <= noise) return "noise";
  Index largest = 0;
  by_held.col(parameter).maxCoeff(&largest);
  return "held: " + held[static_cast<std::size_t>(largest)];
}

std::vector<Contradiction> Certainty::Contradictions() const {
  std::vector<Contradiction> found =
      model_error.by_recording.Contradictions(covariance.reach_95 * Eigen::VectorXd(noise_sd(judged)));
  for (Contradiction& one : found) one.parameter = judged[static_cast<std::size_t>(one.parameter)];
  return found;
}

HeldParameters HeldAt(const VehicleObjective& objective, const Eigen::VectorXd& values, const RefineOptions& refine,
                      int threads, const std::function<bool()>& stop, std::int64_t& evaluated) {
  HeldParameters held = {.places = PlacesHeld(objective), .variable_sd = {}, .jacobian = {}};
  if (held.places.empty() || stop()) return {};
  Vehicle fitted = objective.vehicle();
  const std::vector<double> all = objective.AllParameters(values);
  for (std::size_t i = 0; i < all.size(); ++i) fitted.parameters[i].value = all[i];
  for (Parameter& parameter : fitted.parameters) parameter.prior_sd.reset();
  const VehicleObjective around(fitted, held.places, objective.blocks());
  Archive archive(around.MakeProblem(), threads);
  archive.StopBatches(stop);
  const FitVariables variables(archive.lattice());
  try {
    const Eigen::VectorXd at = around.FileValues();
    const Evaluation here = archive.EvaluateValues({at}).front();
    if (!here.ok()) return {};
    const std::optional<Eigen::MatrixXd> jacobian =
        DifferenceJacobian(archive, variables, variables.FromValues(at), here.residuals,
                           refine.DifferenceStep(archive.problem()), Differences::kAutomatic);
    if (!jacobian) return {};
    held.jacobian = *jacobian;
  } catch (const BatchStopped&) {
    return {};
  }
  evaluated += archive.counts().paid;
  held.variable_sd.resize(static_cast<Index>(held.places.size()));
  for (std::size_t i = 0; i < held.places.size(); ++i)
    held.variable_sd[static_cast<Index>(i)] =
        DeviationOf(objective.vehicle().parameters[held.places[i]], variables, static_cast<Index>(i));
  return held;
}

Certainty CertaintyAt(const VehicleObjective& objective, const Lattice& lattice, const RefineResult& best,
                      const RobustLoss& loss, const std::vector<ParameterState>& states,
                      const Eigen::MatrixXd& input_noise, const HeldParameters& held) {
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
  Eigen::MatrixXd by_held = Eigen::MatrixXd::Zero(static_cast<Index>(certainty.judged.size()), 0);
  if (!held.places.empty()) by_held = optimum.MovedBy(held, certainty.judged);
  for (const std::size_t place : held.places) certainty.held.push_back(objective.vehicle().parameters[place].name);
  certainty.by_held = Eigen::MatrixXd::Zero(by_held.cols(), count);
  const Eigen::VectorXd known = PriorDeviations(objective, lattice, best.values);
  for (std::size_t i = 0; i < certainty.judged.size(); ++i) {
    const auto row = static_cast<Index>(i);
    const Index j = certainty.judged[i];
    certainty.by_held.col(j) = by_held.row(row).transpose().cwiseAbs();
    certainty.held_sd[j] = by_held.row(row).norm();
    const double noise = certainty.noise_sd[j];
    const double disagreement =
        certainty.model_error.is_significant ? certainty.model_error.reach[row] / certainty.covariance.reach_95 : 0;
    certainty.model_sd[j] = disagreement;
    certainty.held_sd[j] = std::min(certainty.held_sd[j], known[j]);
    certainty.model_sd[j] = std::min(certainty.model_sd[j], known[j]);
    certainty.total_sd[j] = std::hypot(noise, certainty.held_sd[j], certainty.model_sd[j]);
  }
  AddCovariances(by_held * by_held.transpose(), certainty);
  return certainty;
}

}  // namespace fourpost
