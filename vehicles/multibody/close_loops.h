#pragma once

#include <functional>

#include <Eigen/Core>

namespace fourpost {

/// Loop equations g(q) = 0 in joint coordinates q [m, rad].
struct LoopEquations {
  /// Moves to a pose and returns g there.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& q)> error_at;
  /// dg/dq in the last pose moved to.
  std::function<Eigen::MatrixXd()> jacobian;
};

struct ClosedLoops {
  Eigen::VectorXd pose;
  /// Largest entry of g below 1e-12.
  bool is_closed = false;
};

/// The pose near `start` that closes the loops, or the best pose found, in which small steps no longer reduce |g|.
/// Newton's method with the least-norm solution of the linearised equations as step, no entry above half a metre or
/// radian. If that does not reduce |g| enough (Armijo), Levenberg's damped step
///   dq = -J' (J J' + d^2 1)^-1 g,
/// with d raised until it does. Leaves the equations in any pose.
ClosedLoops CloseLoops(const LoopEquations& equations, const Eigen::VectorXd& start);

}  // namespace fourpost
