#include "vehicles/loops/chart.h"

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "vehicles/loops/loop_lock.h"
#include "vehicles/loops/loop_space.h"

namespace fourpost {
namespace {

Eigen::MatrixXd Stacked(const Eigen::MatrixXd& upper, const Eigen::MatrixXd& lower) {
  Eigen::MatrixXd stacked(upper.rows() + lower.rows(), upper.cols());
  stacked << upper, lower;
  return stacked;
}

/// Equations that repeat others say the same but for rounding, which must not be divided by.
LeastNorm FactorsOf(const Eigen::MatrixXd& matrix) { return LeastNorm(matrix, kLoopRankTolerance); }

/// Errors of the loops and of s in one column per case.
Eigen::MatrixXd OfLoops(const Eigen::MatrixXd& errors, Eigen::Index size) {
  return Stacked(errors, Eigen::MatrixXd::Zero(size, errors.cols()));
}
Eigen::MatrixXd OfCoordinates(Eigen::Index loops, Eigen::Index size) {
  return Stacked(Eigen::MatrixXd::Zero(loops, size), Eigen::MatrixXd::Identity(size, size));
}

}  // namespace

Chart::Chart(Multibody& multibody) : multibody_(multibody) {
  multibody_.SetPose(multibody_.design_pose());
  const Eigen::MatrixXd loops = multibody_.LoopJacobian();
  has_loops_ = loops.rows() > 0;
  basis_ = LoopSpaceOf(loops).motions;
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
    q -= FactorsOf(Stacked(multibody_.LoopJacobian(), basis_.transpose())).Solve(error);
    multibody_.SetPose(q);
  }
  throw LoopsCannotFollow(multibody_);
}

Chart::Motion Chart::Follow(double t, const Eigen::VectorXd& s, const Eigen::VectorXd& rate,
                            const Eigen::VectorXd& acceleration, const Eigen::VectorXd& z) {
  Motion motion;
  Eigen::VectorXd state;
  const auto move = [&] {
    state.resize(2 * motion.q.size() + z.size());
    state << motion.q, motion.rate, z;
    multibody_.SetState(t, state);
  };
  if (!has_loops_) {
    motion.q = multibody_.design_pose() + basis_ * s;
    motion.tangent = basis_;
    motion.rate = basis_ * rate;
    motion.acceleration = basis_ * acceleration;
    move();
    return motion;
  }
  motion.q = Close(s);
  const Eigen::MatrixXd loops = multibody_.LoopJacobian();
  const LeastNorm solver = FactorsOf(Stacked(loops, basis_.transpose()));
  motion.tangent = solver.Solve(OfCoordinates(loops.rows(), size()));
  motion.rate = motion.tangent * rate;
  move();
  motion.acceleration = motion.tangent * acceleration - solver.Solve(OfLoops(multibody_.LoopBias(), size()));
  return motion;
}

Eigen::MatrixXd Chart::MoveTo(const Eigen::VectorXd& s) {
  Close(s);
  if (!has_loops_) return basis_;
  const Eigen::MatrixXd loops = multibody_.LoopJacobian();
  return FactorsOf(Stacked(loops, basis_.transpose())).Solve(OfCoordinates(loops.rows(), size()));
}

}  // namespace fourpost
