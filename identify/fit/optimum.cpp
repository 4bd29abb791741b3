#include "identify/fit/optimum.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "analysis/numerics/decompositions.h"
#include "identify/refine/fit_variables.h"

namespace fourpost {

using Eigen::Index;

Optimum::Optimum(const VehicleObjective& objective, const Lattice& lattice, const RefineResult& best,
                 const RobustLoss& loss, const Eigen::MatrixXd& input_noise)
    : data_(best.jacobian.rows() - objective.prior_count()),
      jacobian_(best.jacobian.topRows(data_)),
      priors_(best.jacobian.bottomRows(objective.prior_count())),
      residuals_(best.residuals.head(data_)),
      prior_residuals_(best.residuals.tail(objective.prior_count())),
      weights_(loss.OfData().Weights(residuals_)),
      curvatures_(loss.OfData().Curvatures(residuals_)),
      slopes_(FitVariables(lattice).Slopes(best.values)),
      structure_(JoinedStructure(objective.blocks())),
      unmeasured_(objective.unmeasured_count()),
      // With a loss the cost is that of squares that would leave the same variance, but never less than the squares
      // are: a loss bounds the pull of residuals, and knows nothing of why they are so large.
      cost_(std::max(residuals_.squaredNorm(), loss.OfData().EquivalentCost(residuals_, unmeasured_))),
      input_noise_(input_noise),
      noise_(residuals_.cwiseProduct(weights_), structure_, jacobian_) {
  const FitVariables variables(lattice);
  for (Index j = 0; j < variables.size(); ++j) is_relative_.push_back(variables.is_logarithmic(j));
}

Covariance Optimum::NoiseCovariance(const std::vector<Index>& held) const {
  CovarianceOptions options;
  options.held = held;
  options.unmeasured = unmeasured_;
  Covariance covariance = EstimateCovariance(jacobian_, slopes_, cost_, options, priors_);
  if (noise_.HasTime()) UseScoreCovariance(Hessian(curvatures_), Score(), slopes_, covariance);
  return covariance;
}

ModelErrorEstimate Optimum::ModelError(const std::vector<Index>& judged) const {
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

Eigen::MatrixXd Optimum::ByHeld(const HeldParameters& held) const {
  return held.jacobian.topRows(data_) * held.variable_sd.asDiagonal();
}

Eigen::MatrixXd Optimum::MovedBy(const Eigen::MatrixXd& changes, const std::vector<Index>& judged) const {
  const Eigen::MatrixXd hessian = Hessian(weights_)(judged, judged);
  const Eigen::MatrixXd pull = jacobian_(Eigen::all, judged).transpose() * weights_.asDiagonal() * changes;
  return LeastNorm(hessian).Solve(pull);
}

Calibrated Optimum::Calibrate(const Eigen::MatrixXd& changes, const Eigen::MatrixXd& input_noise,
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

Eigen::MatrixXd Optimum::Hessian(const Eigen::VectorXd& weights) const {
  return jacobian_.transpose() * weights.asDiagonal() * jacobian_ + priors_.transpose() * priors_;
}

std::vector<Index> Optimum::UnseenOf(const Eigen::MatrixXd& changes, const Eigen::MatrixXd& left) const {
  constexpr double kDerivatives = 0.01;
  std::vector<Index> unseen;
  const Eigen::VectorXd roots = weights_.cwiseSqrt();
  for (Index c = 0; c < changes.cols(); ++c)
    if (roots.cwiseProduct(left.col(c)).norm() < kDerivatives * roots.cwiseProduct(changes.col(c)).norm())
      unseen.push_back(c);
  return unseen;
}

Eigen::MatrixXd Optimum::ScoreOf(const Eigen::MatrixXd& changes) const {
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

Eigen::MatrixXd Optimum::Score() const {
  Eigen::MatrixXd score = ScoreOf(jacobian_) + priors_.transpose() * priors_;
  // The noise that was added once more to take back a bias scatters, too.
  if (input_noise_.size() == 0) return score;
  score += noise_.CovarianceOfStretches(input_noise_, noise_.over_time());
  // Nor is its power known better, of some thirty segments of a record and a few frequencies in each.
  constexpr double kPower = 0.1;
  const Eigen::VectorXd taken = kPower * input_noise_.colwise().sum();
  return score + taken * taken.transpose();
}

}  // namespace fourpost
