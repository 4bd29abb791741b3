#pragma once

#include <functional>

#include <Eigen/Core>

namespace fourpost {

/// Loop equations g(q) = 0 in joint coordinates q [m, rad].
struct LoopEquations {
  /// Moves to a pose and gives g there.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& q)> error_at;
  /// dg/dq in the pose moved to last.
  std::function<Eigen::MatrixXd()> jacobian;
};

struct ClosedLoops {
  Eigen::VectorXd pose;
  /// Largest entry of g below 1e-12.
  bool is_closed = false;
};

/// The pose near `start` that closes the loops, or one in which |g| does not become less by small steps: the best that
/// was found. Newton's method, each step the least that the linearised equations ask for, no entry of it above half a
/// metre or radian; where that does not bring |g| down enough (Armijo), Levenberg's damped step
///   dq = -J' (J J' + d^2 1)^-1 g,
/// d raised until it does. Leaves the equations in any pose.
ClosedLoops CloseLoops(const LoopEquations& equations, const Eigen::VectorXd& start);

}  // namespace fourpost
