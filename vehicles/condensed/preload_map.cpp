#include "vehicles/condensed/preload_map.h"

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

Eigen::VectorXd PreloadMap::At(const Eigen::VectorXd& force, const Eigen::VectorXd& rates) const {
  // A share that no load cell sees, far above rounding.
  constexpr double kOfAll = 1e-6;
  Eigen::VectorXd preloads = least_ * force;
  if (IsDeterminate()) return preloads;
  const double most = rates.maxCoeff();
  if (!(most > 0)) return preloads;
  const Eigen::VectorXd compliances = most * rates.cwiseMax(kOfAll * most).cwiseInverse();
  const Eigen::MatrixXd weighted = compliances.asDiagonal() * redundant_;
  preloads -= redundant_ * (redundant_.transpose() * weighted).llt().solve(weighted.transpose() * preloads);
  return preloads;
}

}  // namespace fourpost
