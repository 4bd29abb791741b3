#include "identify/uncertainty/covariance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "analysis/signals/student_t.h"
#include "analysis/text/option_check.h"
#include "identify/refine/fit_variables.h"

namespace fourpost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void CheckInput(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& slopes, double cost) {
  if (jacobian.size() == 0 || slopes.size() != jacobian.cols()) {
    throw std::invalid_argument("the Jacobian is " + std::to_string(jacobian.rows()) + " x " +
                                std::to_string(jacobian.cols()) + ", the slopes are " + std::to_string(slopes.size()));
  }
  if (!jacobian.allFinite()) throw std::invalid_argument("the Jacobian has an entry that is not finite");
  if (!(slopes.array() > 0).all()) throw std::invalid_argument("a slope is not a positive number");
  RequireOption(cost >= 0, "cost", cost, "0 or more");
}

void CheckPriors(const Eigen::MatrixXd& priors, Eigen::Index parameters) {
  if (priors.cols() != parameters) {
    throw std::invalid_argument("the priors are of " + std::to_string(priors.cols()) + " parameters, the Jacobian of " +
                                std::to_string(parameters));
  }
  if (!priors.allFinite()) throw std::invalid_argument("the priors have an entry that is not finite");
}

// Signs of singular vectors are arbitrary; this one does not depend on the platform.
void PointAlongLargest(Eigen::Ref<Eigen::VectorXd> direction) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  if (direction[largest] < 0) direction = -direction;
}

void Decompose(const Eigen::MatrixXd& jacobian, double rank_threshold, Covariance& covariance) {
  const Eigen::Index n = jacobian.cols();
  const SingularValues svd = SingularValuesOf(jacobian, SingularValues::kRight);
  covariance.singular_values = Eigen::VectorXd::Zero(n);
  covariance.singular_values.head(svd.values.size()) = svd.values;
  covariance.directions = svd.right;
  for (Eigen::Index i = 0; i < n; ++i) PointAlongLargest(covariance.directions.col(i));

  const Eigen::VectorXd& values = covariance.singular_values;
  const double smallest = rank_threshold * values[0];
  covariance.rank = static_cast<int>((values.array() > smallest).count());
  covariance.determined_condition = covariance.rank > 0 ? values[0] / values[covariance.rank - 1] : kInfinity;
  covariance.condition = covariance.rank == n ? covariance.determined_condition : kInfinity;
}

double Inflation(double cost, Eigen::Index residuals, int rank) {
  if (residuals <= rank) return 1;
  return std::max(1.0, std::sqrt(cost / static_cast<double>(residuals - rank)));
}

/// The data's part of the Jacobian as far as it is determined, over the inflation, and the priors below it. What a
/// prior has in the undetermined directions by their noise alone is cut off: it would seem to determine them.
Eigen::MatrixXd WithPriors(const Covariance& data, const Eigen::MatrixXd& priors, double share_threshold) {
  const Eigen::Index n = data.directions.cols();
  const Eigen::MatrixXd open = data.directions.rightCols(n - data.rank);
  Eigen::MatrixXd both(data.rank + priors.rows(), n);
  both.topRows(data.rank) = (data.singular_values.head(data.rank) / data.inflation).asDiagonal() *
                            data.directions.leftCols(data.rank).transpose();
  for (Eigen::Index i = 0; i < priors.rows(); ++i) {
    const Eigen::RowVectorXd shares = priors.row(i) * open;
    const bool is_noise = shares.norm() <= share_threshold * priors.row(i).norm();
    both.row(data.rank + i) = priors.row(i);
    if (is_noise) both.row(data.rank + i) -= shares * open.transpose();
  }
  return both;
}

double VariableSd(const Covariance& covariance, Eigen::Index j, double share_threshold) {
  const Eigen::VectorXd shares = covariance.directions.row(j);
  const int rank = covariance.rank;
  if (shares.tail(shares.size() - rank).norm() > share_threshold) return kInfinity;
  return (shares.head(rank).array() / covariance.singular_values.head(rank).array()).matrix().norm();
}

/// The places that are not held, in order.
std::vector<Eigen::Index> Judged(Eigen::Index parameters, const std::vector<Eigen::Index>& held) {
  std::vector<bool> is_held(static_cast<std::size_t>(parameters), false);
  for (const Eigen::Index j : held) {
    RequireOption(j >= 0 && j < parameters, "held", static_cast<double>(j), "a place of a parameter");
    is_held[static_cast<std::size_t>(j)] = true;
  }
  std::vector<Eigen::Index> judged;
  for (Eigen::Index j = 0; j < parameters; ++j)
    if (!is_held[static_cast<std::size_t>(j)]) judged.push_back(j);
  return judged;
}

/// Of parameters none of which is held; without `sd`.
Covariance OfJudged(const Eigen::MatrixXd& jacobian, double cost, const CovarianceOptions& options,
                    const Eigen::MatrixXd& priors) {
  // Of the singular values: the priors are exact.
  constexpr double kRounding = 1e-12;
  Covariance covariance;
  covariance.directions.resize(0, 0);
  if (jacobian.cols() > 0) Decompose(jacobian, options.rank_threshold, covariance);
  if (options.inflate) covariance.inflation = Inflation(cost, jacobian.rows() - options.unmeasured, covariance.rank);
  double inflation = covariance.inflation;
  if (priors.rows() > 0 && jacobian.cols() > 0) {
    Decompose(WithPriors(covariance, priors, options.share_threshold), kRounding, covariance);
    inflation = 1;  // in the Jacobian already
  }
  covariance.variable_sd.resize(jacobian.cols());
  for (Eigen::Index j = 0; j < jacobian.cols(); ++j)
    covariance.variable_sd[j] = inflation * VariableSd(covariance, j, options.share_threshold);
  const Eigen::Index free_residuals = jacobian.rows() - options.unmeasured + priors.rows() - jacobian.cols();
  covariance.reach_95 = StudentT95(static_cast<double>(std::max<Eigen::Index>(free_residuals, 1)));
  return covariance;
}

/// Over all parameters: zeros and NaN for those that are held.
void Spread(const std::vector<Eigen::Index>& judged, Eigen::Index parameters, Covariance& covariance) {
  Eigen::MatrixXd directions = Eigen::MatrixXd::Zero(parameters, static_cast<Eigen::Index>(judged.size()));
  Eigen::VectorXd variable_sd = Eigen::VectorXd::Constant(parameters, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < judged.size(); ++i) {
    directions.row(judged[i]) = covariance.directions.row(static_cast<Eigen::Index>(i));
    variable_sd[judged[i]] = covariance.variable_sd[static_cast<Eigen::Index>(i)];
  }
  covariance.directions = std::move(directions);
  covariance.variable_sd = std::move(variable_sd);
}

}  // namespace

void CovarianceOptions::Validate() const {
  RequireOption(rank_threshold > 0 && rank_threshold < 1, "rank_threshold", rank_threshold, "in (0, 1)");
  RequireOption(share_threshold > 0 && share_threshold < 1, "share_threshold", share_threshold, "in (0, 1)");
}

Covariance EstimateCovariance(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& slopes, double cost,
                              const CovarianceOptions& options, const Eigen::MatrixXd& priors) {
  options.Validate();
  CheckInput(jacobian, slopes, cost);
  if (priors.rows() > 0) CheckPriors(priors, jacobian.cols());
  const std::vector<Eigen::Index> judged = Judged(jacobian.cols(), options.held);
  const Eigen::MatrixXd of_priors = priors.rows() > 0 ? Eigen::MatrixXd(priors(Eigen::all, judged)) : priors;
  Covariance covariance = OfJudged(jacobian(Eigen::all, judged), cost, options, of_priors);
  Spread(judged, jacobian.cols(), covariance);
  covariance.sd = covariance.variable_sd.cwiseProduct(slopes);
  return covariance;
}

void UseScoreCovariance(const Eigen::MatrixXd& hessian, const Eigen::MatrixXd& score, const Eigen::VectorXd& slopes,
                        Covariance& covariance) {
  if (covariance.rank == 0) return;
  const Eigen::MatrixXd basis = covariance.directions.leftCols(covariance.rank);
  const Eigen::MatrixXd within = basis.transpose() * hessian * basis;
  const Eigen::MatrixXd shaped = Solved(within, Eigen::MatrixXd(basis.transpose()));  // rank x n
  const Eigen::MatrixXd middle = basis.transpose() * score * basis;
  const Eigen::VectorXd variances = (shaped.transpose() * middle * shaped).diagonal();
  for (Eigen::Index j = 0; j < variances.size(); ++j)
    if (std::isfinite(covariance.variable_sd[j])) covariance.variable_sd[j] = std::sqrt(std::max(variances[j], 0.0));
  covariance.sd = covariance.variable_sd.cwiseProduct(slopes);
}

Eigen::MatrixXd Correlations(const Covariance& covariance) {
  const int rank = covariance.rank;
  const Eigen::MatrixXd scaled =
      covariance.directions.leftCols(rank) * covariance.singular_values.head(rank).cwiseInverse().asDiagonal();
  Eigen::MatrixXd correlations(scaled.rows(), scaled.rows());
  for (Eigen::Index i = 0; i < scaled.rows(); ++i)
    for (Eigen::Index j = 0; j < scaled.rows(); ++j) {
      const bool known = std::isfinite(covariance.variable_sd[i]) && std::isfinite(covariance.variable_sd[j]);
      const double product = scaled.row(i).norm() * scaled.row(j).norm();
      correlations(i, j) = !known   ? std::numeric_limits<double>::quiet_NaN()
                           : i == j ? 1.0
                                    : scaled.row(i).dot(scaled.row(j)) / product;
    }
  return correlations;
}

std::string DescribeDirection(const Lattice& lattice, const Eigen::VectorXd& direction) {
  constexpr double kLeastShare = 0.05;
  const FitVariables variables(lattice);
  RequireOption(direction.size() == variables.size(), "size of the direction", direction.size(),
                std::to_string(variables.size()));
  std::vector<Eigen::Index> order(lattice.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return std::abs(direction[a]) > std::abs(direction[b]); });

  std::ostringstream text;
  text.precision(2);
  const double strongest = direction[order.front()];
  for (const Eigen::Index j : order) {
    const double change = direction[j] / strongest;
    if (!(std::abs(change) >= kLeastShare)) break;
    text << (j == order.front() ? "" : ", ") << lattice.axes()[static_cast<std::size_t>(j)].name << " " << std::showpos
         << change << std::noshowpos << (variables.is_logarithmic(j) ? " %" : " % of range");
  }
  return text.str();
}

}  // namespace fourpost
