#include "analysis/numerics/anderson_acceleration.h"

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

Eigen::MatrixXd Columns(const std::deque<Eigen::VectorXd>& vectors) {
  Eigen::MatrixXd columns(vectors.front().size(), static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t i = 0; i < vectors.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = vectors[i];
  return columns;
}

}  // namespace

Eigen::VectorXd AndersonAcceleration::Next(const Eigen::VectorXd& x, const Eigen::VectorXd& f) {
  if (iterate_.size() > 0) {
    iterate_changes_.push_back(x - iterate_);
    step_changes_.push_back(f - step_);
  }
  if (iterate_changes_.size() > history_) {
    iterate_changes_.pop_front();
    step_changes_.pop_front();
  }
  iterate_ = x;
  step_ = f;
  if (step_changes_.empty()) return x + f;
  const Eigen::MatrixXd step_changes = Columns(step_changes_);
  // Column pivoting leaves out differences that add nothing.
  const Eigen::VectorXd weights = LeastSquares(step_changes, f);
  return x + f - (Columns(iterate_changes_) + step_changes) * weights;
}

}  // namespace fourpost
