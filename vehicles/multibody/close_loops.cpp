#include "vehicles/multibody/close_loops.h"

#include <algorithm>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

/// Some thousand roundings of metres.
bool IsClosed(const Eigen::VectorXd& error) { return error.size() == 0 || error.lpNorm<Eigen::Infinity>() < 1e-12; }

/// A longer one leaves the neighbourhood in which the equations are about linear: links are metres long.
double ShareInReach(const Eigen::VectorXd& step) {
  constexpr double kLongest = 0.5;
  return std::min(1.0, kLongest / step.lpNorm<Eigen::Infinity>());
}

class LoopCloser {
 public:
  LoopCloser(const LoopEquations& equations, const Eigen::VectorXd& start)
      : equations_(equations), pose_(start), error_(equations.error_at(start)) {}

  ClosedLoops Close() {
    // A quarter of the error is left by each where two solutions meet, less elsewhere; they reach as far as a vehicle.
    constexpr int kSteps = 100;
    for (int k = 0; k < kSteps && !IsClosed(error_); ++k)
      if (!Improve(equations_.jacobian())) break;
    return {.pose = pose_, .is_closed = IsClosed(error_)};
  }

 private:
  bool Improve(const Eigen::MatrixXd& jacobian) {
    // Share of the decrease that the linearised equations promise; a usual choice.
    constexpr double kArmijo = 0.1;
    const Eigen::VectorXd newton = -LeastNorm(jacobian).Solve(error_);
    const double share = ShareInReach(newton);
    return Try(share * newton, 1 - kArmijo * share) || ImproveDamped(jacobian);
  }

  bool ImproveDamped(const Eigen::MatrixXd& jacobian) {
    // Between what the square of the Jacobian can separate from rounding and steps that are lost in it.
    constexpr double kLeast = 1e-4;
    constexpr double kGreatest = 1e4;
    // What is less is rounding of a pose that cannot be better.
    constexpr double kDecrease = 1e-9;
    const Eigen::MatrixXd square = jacobian * jacobian.transpose();
    const auto one = Eigen::MatrixXd::Identity(square.rows(), square.cols());
    const double scale = jacobian.norm();
    for (double damping = kLeast; damping < kGreatest; damping *= 10) {
      const double d = damping * scale;
      const Eigen::VectorXd step = -jacobian.transpose() * (square + d * d * one).llt().solve(error_);
      if (Try(ShareInReach(step) * step, 1 - kDecrease)) return true;
    }
    return false;
  }

  /// Takes the step if no more than this share of the error is left.
  bool Try(const Eigen::VectorXd& step, double left) {
    if (!step.allFinite()) return false;
    const Eigen::VectorXd pose = pose_ + step;
    const Eigen::VectorXd error = equations_.error_at(pose);
    if (!(error.norm() <= left * error_.norm())) return false;
    pose_ = pose;
    error_ = error;
    return true;
  }

  const LoopEquations& equations_;
  Eigen::VectorXd pose_;
  Eigen::VectorXd error_;
};

}  // namespace

ClosedLoops CloseLoops(const LoopEquations& equations, const Eigen::VectorXd& start) {
  return LoopCloser(equations, start).Close();
}

}  // namespace fourpost
