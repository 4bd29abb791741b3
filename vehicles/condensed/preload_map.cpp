#include "vehicles/condensed/preload_map.h"

#include <limits>

#include <Eigen/Cholesky>

#include "analysis/numerics/decompositions.h"

namespace fourpost {

PreloadMap::PreloadMap(const Eigen::MatrixXd& holders)
    : least_(Eigen::MatrixXd::Zero(holders.cols(), holders.rows())), redundant_(holders.cols(), 0) {
  if (holders.size() == 0) return;
  const LeastNorm factors(holders, kHeldShare);
  least_ = -factors.PseudoInverse();
  if (factors.rank() == holders.cols()) return;
  redundant_ = factors.NullSpace();
}

Eigen::VectorXd PreloadMap::At(const Eigen::VectorXd& force,
                               const std::function<HolderTangents(const Eigen::VectorXd&)>& tangents) const {
  // The error after a step of this size is about its square.
  constexpr double kStep = 1e-9;
  constexpr int kMostSteps = 100;
  Eigen::VectorXd preloads = least_ * force;
  if (IsDeterminate()) return preloads;
  // Shorter ones where a curve's rates alternate, so that they would go to and fro.
  double share = 1;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostSteps; ++i) {
    const HolderTangents now = tangents(preloads);
    const Eigen::VectorXd step = At(force, now) - preloads;
    if (now.slack.size() == 0) return preloads + step;
    if (step.norm() >= last) share /= 2;
    last = step.norm();
    preloads += share * step;
    if (last <= kStep * preloads.norm()) break;
  }
  return preloads;
}

Eigen::VectorXd PreloadMap::At(const Eigen::VectorXd& force, const HolderTangents& tangents) const {
  // A share that no load cell sees, far above rounding.
  constexpr double kOfAll = 1e-6;
  Eigen::VectorXd preloads = least_ * force;
  if (IsDeterminate()) return preloads;
  const Eigen::VectorXd& rates = tangents.rates;
  const double most = rates.maxCoeff();
  if (!(most > 0)) return preloads;
  const Eigen::VectorXd compliances = most * rates.cwiseMax(kOfAll * most).cwiseInverse();
  const Eigen::MatrixXd weighted = compliances.asDiagonal() * redundant_;
  Eigen::VectorXd strain = preloads;
  if (tangents.slack.size() > 0) strain -= tangents.slack;
  preloads -= redundant_ * (redundant_.transpose() * weighted).llt().solve(weighted.transpose() * strain);
  return preloads;
}

}  // namespace fourpost
