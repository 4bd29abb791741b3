#include "vehicles/chart.h"

#include <Eigen/QR>
#include <Eigen/SVD>

#include "analysis/diagnostics.h"

namespace fourpost {
namespace {

/// Singular values below this share of the largest count as zero; exact redundancy leaves about 1e-16.
constexpr double kRankTolerance = 1e-9;

Eigen::MatrixXd NullSpace(const Eigen::MatrixXd& jacobian) {
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeFullV);
  svd.setThreshold(kRankTolerance);
  return svd.matrixV().rightCols(jacobian.cols() - svd.rank());
}

Eigen::MatrixXd Stacked(const Eigen::MatrixXd& upper, const Eigen::MatrixXd& lower) {
  Eigen::MatrixXd stacked(upper.rows() + lower.rows(), upper.cols());
  stacked << upper, lower;
  return stacked;
}

}  // namespace

Chart::Chart(Multibody& multibody) : multibody_(multibody) {
  multibody_.SetPose(multibody_.design_pose());
  const Eigen::MatrixXd loops = multibody_.LoopJacobian();
  const int n = multibody_.coordinate_count();
  has_loops_ = loops.rows() > 0;
  basis_ = has_loops_ ? NullSpace(loops) : Eigen::MatrixXd::Identity(n, n);
}

Eigen::VectorXd Chart::Close(const Eigen::VectorXd& s) {
  // Some hundred roundings of metres; differences of such poses over millimetres keep 1e-10 of second derivatives.
  constexpr double kClosed = 1e-13;
  constexpr int kIterations = 30;
  Eigen::VectorXd q = multibody_.design_pose() + basis_ * s;
  multibody_.SetPose(q);
  if (!has_loops_) return q;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const Eigen::VectorXd loop_error = multibody_.LoopError();
    Eigen::VectorXd error(loop_error.size() + s.size());
    error << loop_error, basis_.transpose() * (q - multibody_.design_pose()) - s;
    if (error.lpNorm<Eigen::Infinity>() < kClosed) return q;
    const Eigen::MatrixXd jacobian = Stacked(multibody_.LoopJacobian(), basis_.transpose());
    q -= jacobian.completeOrthogonalDecomposition().solve(error);
    multibody_.SetPose(q);
  }
  Diagnostics faults;
  faults.Error(
      multibody_.vehicle().file, 0,
      "the loops lock the vehicle: they cannot follow a small motion; check the positions of fp:rod and fp:ball");
  throw FaultyInput(faults);
}

Eigen::MatrixXd Chart::MoveTo(const Eigen::VectorXd& s) {
  Close(s);
  if (!has_loops_) return basis_;
  const Eigen::MatrixXd loops = multibody_.LoopJacobian();
  Eigen::MatrixXd target = Eigen::MatrixXd::Zero(loops.rows() + size(), size());
  target.bottomRows(size()).setIdentity();
  return Stacked(loops, basis_.transpose()).completeOrthogonalDecomposition().solve(target);
}

}  // namespace fourpost
