#include "vehicles/loops/loop_space.h"

#include <algorithm>

#include <Eigen/SVD>

namespace fourpost {

LoopSpace LoopSpaceOf(const Eigen::MatrixXd& jacobian, Eigen::Index most) {
  const Eigen::Index rows = jacobian.rows();
  const Eigen::Index columns = jacobian.cols();
  LoopSpace space;
  space.motions = Eigen::MatrixXd::Identity(columns, columns);
  space.stresses = Eigen::MatrixXd::Identity(rows, rows);
  if (jacobian.size() == 0) return space;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double tolerance = kLoopRankTolerance * std::max(1.0, svd.singularValues()[0]);
  space.rank = std::min(most, (svd.singularValues().array() > tolerance).count());
  if (space.rank > 0) space.least = svd.singularValues()[space.rank - 1];
  space.motions = svd.matrixV().rightCols(columns - space.rank);
  space.stresses = svd.matrixU().rightCols(rows - space.rank);
  return space;
}

}  // namespace fourpost
