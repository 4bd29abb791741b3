#include "identify/uncertainty/derivative_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identify/refine/difference_jacobian.h"
#include "identify/uncertainty/covariance.h"

namespace fourpost {
namespace {

double LargestOf(const Eigen::VectorXd& norms, const std::vector<bool>& is_noisy) {
  double largest = 0;
  for (Eigen::Index j = 0; j < norms.size(); ++j)
    if (!is_noisy[static_cast<std::size_t>(j)]) largest = std::max(largest, norms[j]);
  return largest;
}

/// Those of which the larger part is noise.
std::vector<Eigen::Index> LoudColumns(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& again) {
  constexpr double kNoise = 0.5;
  const double counts = CovarianceOptions().rank_threshold;
  const Eigen::VectorXd disagreement = Disagreement(jacobian, again);
  const Eigen::VectorXd norms = jacobian.colwise().norm();
  std::vector<bool> is_noisy(static_cast<std::size_t>(norms.size()), false);
  // Next to loud noise the effect of others seems too small to count.
  for (bool found = true; found;) {
    found = false;
    // Residuals are over their deviations: what changes them by less, all of its range through, has no effect at all.
    const double least = counts * std::max(1.0, LargestOf(norms, is_noisy));
    for (Eigen::Index j = 0; j < norms.size(); ++j) {
      if (is_noisy[static_cast<std::size_t>(j)] || !(disagreement[j] > kNoise) || !(norms[j] > least)) continue;
      is_noisy[static_cast<std::size_t>(j)] = found = true;
    }
  }
  std::vector<Eigen::Index> noisy;
  for (Eigen::Index j = 0; j < norms.size(); ++j)
    if (is_noisy[static_cast<std::size_t>(j)]) noisy.push_back(j);
  return noisy;
}

/// Those that are noise as far as no other parameter can do the same, which is what determines them: the disagreement
/// is larger than that part, and the two Jacobians make different deviations of it.
std::vector<Eigen::Index> HiddenColumns(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& again,
                                        const std::vector<Eigen::Index>& held) {
  constexpr double kSame = 1.5;
  const Eigen::VectorXd slopes = Eigen::VectorXd::Ones(jacobian.cols());
  const CovarianceOptions options{.inflate = false, .held = held};
  const Eigen::VectorXd sd = EstimateCovariance(jacobian, slopes, 0, options).sd;
  const Eigen::VectorXd sd_again = EstimateCovariance(again, slopes, 0, options).sd;
  std::vector<Eigen::Index> hidden;
  for (Eigen::Index j = 0; j < jacobian.cols(); ++j) {
    if (!std::isfinite(sd[j]) || !std::isfinite(sd_again[j])) continue;
    const double change = std::max(sd[j] / sd_again[j], sd_again[j] / sd[j]);
    if (change > kSame && (jacobian.col(j) - again.col(j)).norm() * sd[j] > 1) hidden.push_back(j);
  }
  return hidden;
}

}  // namespace

std::optional<Eigen::MatrixXd> JacobianAgain(Archive& archive, const FitVariables& variables, const Eigen::VectorXd& x,
                                             const Eigen::VectorXd& residuals, double step) {
  return DifferenceJacobian(archive, variables, x, residuals, step / 3, Differences::kAutomatic);
}

Eigen::VectorXd Disagreement(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& again) {
  const Eigen::VectorXd norms = jacobian.colwise().norm().cwiseMax(again.colwise().norm());
  return (jacobian - again)
      .colwise()
      .norm()
      .transpose()
      .cwiseQuotient(norms.cwiseMax(std::numeric_limits<double>::min()));
}

std::vector<Eigen::Index> NoisyColumns(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& again) {
  std::vector<Eigen::Index> noisy = LoudColumns(jacobian, again);
  const std::vector<Eigen::Index> hidden = HiddenColumns(jacobian, again, noisy);
  noisy.insert(noisy.end(), hidden.begin(), hidden.end());
  std::sort(noisy.begin(), noisy.end());
  return noisy;
}

}  // namespace fourpost
