#pragma once

#include <functional>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include "vehicles/multibody/kinematics.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// Poses at rest of a multibody system in its full geometry, some motions of which are guided:
///   r(q) = G' l + D' f,   g(q) = 0,   c(q) = 0,
/// r: forces that the joint coordinates q lack for rest, weights and elements counted; g: loops, G = dg/dq, their
/// forces l; c: guides, C = dc/dq; D: directions in which the guides push, their forces f. Dampers carry nothing, those
/// of gas excepted; hydraulic ones push as in the design pose.
class RestSolver {
 public:
  /// In one pose: c [m or rad], C and D, one row per guide.
  struct Guides {
    Eigen::VectorXd error;
    Eigen::MatrixXd jacobian;
    Eigen::MatrixXd directions;
  };
  using Guide = std::function<Guides(const Kinematics&)>;

  struct Rest {
    Eigen::VectorXd q;
    /// Of the loops, then of the guides [N or N m].
    Eigen::VectorXd forces;
  };

  /// `multibody`: with parameters and preloads; must outlive this object.
  explicit RestSolver(Multibody& multibody) : multibody_(multibody) {}

  /// Forces on q from outside that help to rest, r(q) = G' l + D' f + forces; none at first.
  void Carry(Eigen::VectorXd forces) { carried_ = std::move(forces); }
  /// What lacks for rest in a pose, r(q).
  Eigen::VectorXd Lacking(const Eigen::VectorXd& q);

  /// Newton's method from a pose near by; empty if it does not converge. Without motions that loops and guides leave
  /// free, the pose is that of the geometry alone.
  std::optional<Rest> Solve(const Rest& start, const Guide& guide);

  /// Change of q, in columns, for small additional forces on q and small motions of the guides, c = motions; in columns
  /// alike. Empty if the pose cannot follow, or if nothing holds a motion that the forces cause. Moves the multibody to
  /// the pose.
  std::optional<Eigen::MatrixXd> Respond(const Rest& rest, const Guide& guide, const Eigen::MatrixXd& forces,
                                         const Eigen::MatrixXd& motions);

  /// Motions that loops and guides leave free.
  Eigen::Index FreeMotions(const Rest& rest, const Guide& guide);

 private:
  struct Equations;
  Equations At(const Eigen::VectorXd& q, const Guide& guide);
  /// d(r - G' l - D' f)/dq at these forces.
  Eigen::MatrixXd Stiffness(const Rest& rest, const Guide& guide);

  Multibody& multibody_;
  Eigen::VectorXd carried_;
};

}  // namespace fourpost
