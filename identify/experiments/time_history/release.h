#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"

namespace fourpost {

/// From where a vehicle is let go at the first sample of a history; before, it was held, and no post moves it.
struct Release {
  enum class From {
    /// Any pose and velocity; both are estimated.
    kAnyState,
    /// Any pose, at rest.
    kRest,
    /// The pose of static equilibrium in which forces along what some displacement sensors measure hold them at given
    /// readings: a body that hangs, with its suspension drooping and its tyres in the air, or one that is pulled down.
    kHeld,
  };
  struct Hold {
    std::string sensor;
    /// Of the vehicle.
    std::size_t index = 0;
    /// Above that of the vehicle at rest [m]; empty: estimated.
    std::optional<double> reading_m = {};
    int line = 0;
  };
  From from = From::kAnyState;
  std::vector<Hold> held = {};
  /// From where the estimate starts; empty: from what displacement sensors measured.
  Eigen::VectorXd guess = {};
  /// As a share of each signal's deviation, see HistoryResiduals.
  double model_error = 0.02;

  /// Unknown quantities [m], and velocities of coordinates [m/s or rad/s] behind those of a pose; then, unless the
  /// vehicle is held, the tension of each friction that sticks over its stiffness [m].
  Eigen::Index Unknowns(const CondensedModel& model) const;
  /// Of each, how far from zero it may be: a tension up to the sliding force.
  Eigen::VectorXd Reach(const CondensedModel& model) const;
};

/// [s s' x] of these unknowns, with the strokes behind them as CondensedStepper::SetState takes them. Throws
/// SimulationError where no pose is found.
Eigen::VectorXd ReleasedState(const Release& release, const CondensedModel& model, const Eigen::VectorXd& unknowns);

/// Static equilibrium with these sensors held at these readings: s with
///   stiffness s + nonlinear forces(s) = C' h,  C s = readings,
/// C: rows of the sensors, h: what holds them. Newton's method with halved steps. Throws SimulationError.
Eigen::VectorXd HeldPose(const CondensedModel& model, const Eigen::MatrixXd& rows, const Eigen::VectorXd& readings);

/// Unknowns by Levenberg and Marquardt.
struct EstimatedStart {
  Eigen::VectorXd unknowns;
  /// Of them, given all else, for residuals of variance 1 over those left; empty without unknowns.
  Eigen::MatrixXd covariance;
};
/// `residuals`: of unknowns. Those that residuals say nothing of stay. `reach`: of each, its largest size.
EstimatedStart EstimateStart(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& residuals,
                             const Eigen::VectorXd& guess, const Eigen::VectorXd& reach);

}  // namespace fourpost
