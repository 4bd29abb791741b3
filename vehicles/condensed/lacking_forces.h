#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/port.h"
#include "vehicles/loops/chart.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// Inverse dynamics of the full multibody system along a motion of its reduced model: the additional forces that the
/// motion needs, and the sensor readings. Motions and forces are those of [s x], see LinearVehicle; s: the coordinates
/// of Chart about the design pose, which is the static equilibrium.
class LackingForces {
 public:
  /// `multibody` must carry the parameters and preloads of `model`, and outlive this object. Throws
  /// std::invalid_argument for a model with other dampers.
  LackingForces(Multibody& multibody, const CondensedModel& model);

  struct Motion {
    /// [s x] and [s' x'].
    Eigen::VectorXd position;
    Eigen::VectorXd rate;
    /// s''.
    Eigen::VectorXd acceleration;
    /// Of the hydraulic dampers, two each [MPa above rest], then of friction that sticks [of its sliding force].
    Eigen::VectorXd memory;
  };

  /// Lacking force along dq/ds, at time t. Throws SimulationError if Simbody cannot evaluate the pose, FaultyInput if
  /// the loops cannot follow.
  Eigen::VectorXd At(double t, const Motion& motion);

  /// Sensor readings of the motion evaluated last.
  Eigen::VectorXd Readings() const { return multibody_.Readings(derivative_); }

  /// Extension of each hydraulic damper with its mount, then of each friction that sticks, from the design pose, in
  /// this position [m].
  Eigen::VectorXd MemoryExtensions(const Eigen::VectorXd& position);

  Eigen::Index size() const { return size_; }
  /// Indices in PortsOf() of the hydraulic dampers, in file order.
  const std::vector<std::size_t>& hydraulics() const { return hydraulics_; }
  /// The same of friction that sticks.
  const std::vector<std::size_t>& frictions() const { return frictions_; }
  /// Whether any element has a memory.
  bool HasMemory() const { return !hydraulics_.empty() || !frictions_.empty(); }

 private:
  Eigen::VectorXd States(const Eigen::VectorXd& of_series, const Eigen::VectorXd& of_memory) const;

  Multibody& multibody_;
  Chart chart_;
  Eigen::Index size_ = 0;
  /// Indices in [s x] of the extensions that are states of the multibody system: those of series dampers.
  std::vector<Eigen::Index> series_;
  /// Directions of the series dampers, n x their number.
  Eigen::MatrixXd series_directions_;
  std::vector<std::size_t> hydraulics_;
  std::vector<std::size_t> frictions_;
  /// Derivative of [q u z].
  Eigen::VectorXd derivative_;
};

}  // namespace fourpost
