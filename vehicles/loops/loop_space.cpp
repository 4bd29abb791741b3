#include "vehicles/loops/loop_space.h"

#include <algorithm>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"

namespace fourpost {

LoopSpace LoopSpaceOf(const Eigen::MatrixXd& jacobian, Eigen::Index most) {
  const Eigen::Index rows = jacobian.rows();
  const Eigen::Index columns = jacobian.cols();
  LoopSpace space;
  space.motions = Eigen::MatrixXd::Identity(columns, columns);
  space.stresses = Eigen::MatrixXd::Identity(rows, rows);
  if (jacobian.size() == 0) return space;
  const SingularValues svd = SingularValuesOf(jacobian, SingularValues::kBoth);
  const double tolerance = kLoopRankTolerance * std::max(1.0, svd.values[0]);
  space.rank = std::min(most, (svd.values.array() > tolerance).count());
  if (space.rank > 0) space.least = svd.values[space.rank - 1];
  space.motions = svd.right.rightCols(columns - space.rank);
  space.stresses = svd.left.rightCols(rows - space.rank);
  return space;
}

}  // namespace fourpost
