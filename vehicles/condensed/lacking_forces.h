#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/port.h"
#include "vehicles/loops/chart.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// Inverse dynamics of the full multibody system along a motion of its condensed model: the forces that it lacks to
/// move so, and what its sensors read. Motions and forces are those of [s x], see LinearVehicle; s: the coordinates of
/// Chart about the design pose, which is the static equilibrium.
class LackingForces {
 public:
  /// `multibody` must carry the parameters and preloads of `model`, and outlive this object. Throws
  /// std::invalid_argument for a model of other dampers.
  LackingForces(Multibody& multibody, const CondensedModel& model);

  struct Motion {
    /// [s x] and [s' x'].
    Eigen::VectorXd position;
    Eigen::VectorXd rate;
    /// s''.
    Eigen::VectorXd acceleration;
    /// Of the hydraulic dampers, two each [MPa above rest].
    Eigen::VectorXd pressures;
  };

  /// Along dq/ds, at time t. Throws SimulationError where Simbody cannot evaluate the pose, FaultyInput where the
  /// loops cannot follow.
  Eigen::VectorXd At(double t, const Motion& motion);

  /// Of the sensors, in the motion evaluated last.
  Eigen::VectorXd Readings() const { return multibody_.Readings(derivative_); }

  /// Of each hydraulic damper with its mount, from the design pose on, in this position [m].
  Eigen::VectorXd HydraulicExtensions(const Eigen::VectorXd& position);

  Eigen::Index size() const { return size_; }
  /// Indices in PortsOf() of the hydraulic dampers, in file order.
  const std::vector<std::size_t>& hydraulics() const { return hydraulics_; }

 private:
  Eigen::VectorXd States(const Eigen::VectorXd& of_series, const Eigen::VectorXd& of_pressures) const;

  Multibody& multibody_;
  Chart chart_;
  Eigen::Index size_ = 0;
  /// Indices in [s x] of the extensions that are states of the multibody system: those of series dampers.
  std::vector<Eigen::Index> series_;
  /// Of the series dampers, n x their number.
  Eigen::MatrixXd series_directions_;
  std::vector<std::size_t> hydraulics_;
  /// Of [q u z].
  Eigen::VectorXd derivative_;
};

}  // namespace fourpost
