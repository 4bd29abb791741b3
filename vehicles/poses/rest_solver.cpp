#include "vehicles/poses/rest_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "vehicles/loops/loop_space.h"

namespace fourpost {
namespace {

using Eigen::Index;

Eigen::MatrixXd Above(const Eigen::MatrixXd& upper, const Eigen::MatrixXd& lower) {
  Eigen::MatrixXd both(upper.rows() + lower.rows(), upper.cols());
  both << upper, lower;
  return both;
}

/// Rounding of metres and of some ten coordinates.
constexpr double kClosedPose = 1e-12;
/// Of radians and metres: a Newton step that changes nothing.
constexpr double kStillStep = 1e-11;

/// [N/m, N m/rad]: makes a stiffness one.
double ScaleOf(const Eigen::MatrixXd& stiffness) { return std::max(1.0, stiffness.cwiseAbs().maxCoeff()); }

}  // namespace

/// Constraints of loops and guides in one pose, in common rows.
struct RestSolver::Equations {
  Eigen::VectorXd lacking;
  Eigen::VectorXd error;
  Eigen::MatrixXd jacobian;
  Eigen::MatrixXd directions;

  Index coordinates() const { return jacobian.cols(); }
  Index rows() const { return jacobian.rows(); }

  /// The equations of q and the forces, the latter in units of `scale`, which makes all entries about one or less.
  LeastNorm Factors(const Eigen::MatrixXd& stiffness, double scale) const {
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(coordinates() + rows(), coordinates() + rows());
    all.topLeftCorner(coordinates(), coordinates()) = stiffness / scale;
    all.topRightCorner(coordinates(), rows()) = -directions.transpose();
    all.bottomLeftCorner(rows(), coordinates()) = jacobian;
    return LeastNorm(all, kLoopRankTolerance);
  }
};

Eigen::VectorXd RestSolver::Lacking(const Eigen::VectorXd& q) {
  Eigen::VectorXd state = Eigen::VectorXd::Zero(multibody_.state_size());
  state.head(q.size()) = q;
  return multibody_.Residual(0, state, Eigen::VectorXd::Zero(state.size())).head(q.size());
}

RestSolver::Equations RestSolver::At(const Eigen::VectorXd& q, const Guide& guide) {
  Equations equations{.lacking = Lacking(q), .error = {}, .jacobian = {}, .directions = {}};
  if (carried_.size() > 0) equations.lacking -= carried_;
  const Eigen::MatrixXd loops = multibody_.LoopJacobian();
  const Guides guides = guide(Kinematics(multibody_));
  equations.error = Above(multibody_.LoopError(), guides.error);
  equations.jacobian = Above(loops, guides.jacobian);
  equations.directions = Above(loops, guides.directions);
  return equations;
}

Eigen::MatrixXd RestSolver::Stiffness(const Rest& rest, const Guide& guide) {
  // Truncation leaves 1e-10 of stiffnesses, rounding of some kN the same of those of bushes.
  constexpr double kStep = 1e-5;
  // What is carried is the same in all poses.
  const auto rest_at = [&](const Eigen::VectorXd& q) {
    const Eigen::VectorXd lacking = Lacking(q);
    const Eigen::MatrixXd directions = guide(Kinematics(multibody_)).directions;
    const Eigen::VectorXd of_loops = multibody_.LoopForces(rest.forces.head(rest.forces.size() - directions.rows()));
    return Eigen::VectorXd(lacking - of_loops - directions.transpose() * rest.forces.tail(directions.rows()));
  };
  const Index n = rest.q.size();
  Eigen::MatrixXd stiffness(n, n);
  for (Index i = 0; i < n; ++i) {
    const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(n, i);
    stiffness.col(i) = (rest_at(rest.q + step) - rest_at(rest.q - step)) / (2 * kStep);
  }
  return stiffness;
}

Index RestSolver::FreeMotions(const Rest& rest, const Guide& guide) {
  const Equations equations = At(rest.q, guide);
  return equations.coordinates() - LoopSpaceOf(equations.jacobian).rank;
}

std::optional<RestSolver::Rest> RestSolver::Solve(const Rest& start, const Guide& guide) {
  constexpr int kIterations = 40;
  // A stiffness serves as long as each step is this share of the one before at most.
  constexpr double kFast = 0.2;
  Rest rest = start;
  Equations equations = At(rest.q, guide);
  if (rest.forces.size() != equations.rows()) rest.forces = Eigen::VectorXd::Zero(equations.rows());
  const bool is_rigid = LoopSpaceOf(equations.jacobian).rank == equations.coordinates();
  Eigen::MatrixXd stiffness;
  bool is_slow = false;
  double last = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    Eigen::VectorXd step;
    if (is_rigid) {
      step = LeastNorm(equations.jacobian, kLoopRankTolerance).Solve(Eigen::VectorXd(-equations.error));
    } else {
      if (stiffness.size() == 0 || is_slow) stiffness = Stiffness(rest, guide);
      const double scale = ScaleOf(stiffness);
      Eigen::VectorXd right(equations.coordinates() + equations.rows());
      right << (equations.directions.transpose() * rest.forces - equations.lacking) / scale, -equations.error;
      const Eigen::VectorXd change = equations.Factors(stiffness, scale).Solve(right);
      step = change.head(equations.coordinates());
      rest.forces += scale * change.tail(equations.rows());
    }
    const double size = step.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(size)) return std::nullopt;
    rest.q += step;
    equations = At(rest.q, guide);
    const bool is_closed = equations.error.size() == 0 || equations.error.lpNorm<Eigen::Infinity>() < kClosedPose;
    if (is_closed && size < kStillStep) {
      if (is_rigid)
        rest.forces = LeastNorm(equations.directions.transpose(), kLoopRankTolerance).Solve(equations.lacking);
      return rest;
    }
    is_slow = size > kFast * last;
    last = size;
  }
  return std::nullopt;
}

std::optional<Eigen::MatrixXd> RestSolver::Respond(const Rest& rest, const Guide& guide, const Eigen::MatrixXd& forces,
                                                   const Eigen::MatrixXd& motions) {
  // Rounding; what does not follow at all misses by a share.
  constexpr double kMissedShare = 1e-6;
  const bool is_rigid = FreeMotions(rest, guide) == 0;
  const Eigen::MatrixXd stiffness =
      is_rigid ? Eigen::MatrixXd(Eigen::MatrixXd::Zero(rest.q.size(), rest.q.size())) : Stiffness(rest, guide);
  const Equations equations = At(rest.q, guide);
  const Index n = equations.coordinates();
  const double scale = ScaleOf(stiffness);
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n + equations.rows(), forces.cols());
  all.topRows(n) = forces / scale;
  all.bottomRows(motions.rows()) = motions;
  const Eigen::MatrixXd change = equations.Factors(stiffness, scale).Solve(all);
  Eigen::MatrixXd back(all.rows(), all.cols());
  back.topRows(n) =
      stiffness / scale * change.topRows(n) - equations.directions.transpose() * change.bottomRows(equations.rows());
  back.bottomRows(equations.rows()) = equations.jacobian * change.topRows(n);
  for (Index k = 0; k < all.cols(); ++k)
    if ((back.col(k) - all.col(k)).norm() > kMissedShare * all.col(k).norm()) return std::nullopt;
  return Eigen::MatrixXd(change.topRows(n));
}

}  // namespace fourpost
