#pragma once

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"

namespace fourpost {

/// A reduced vehicle about static equilibrium with dashpots at their mean rates, as a linear system
///   X' = a X + b z,  y = c X + d z + d_rate z' + d_acceleration z''
/// of X = [s, s', x] (LinearVehicle; s' minus the part that the posts' velocities cause at once through the damping of
/// tyres), heights z of the posts and readings y of the sensors. Thesis eqs. 4.11-4.12 for a quarter car.
struct StateSpace {
  explicit StateSpace(const CondensedModel& model);

  /// Readings after an impulse of the posts' heights, z = shape delta(t), at `samples` times 0, step_s, 2 step_s ...;
  /// samples x sensors [unit of the sensor per m s]. The impulses of the d terms at t = 0 itself are omitted.
  Eigen::MatrixXd ImpulseResponse(const Eigen::VectorXd& shape, double step_s, Eigen::Index samples) const;

  Eigen::MatrixXd a;
  /// states x posts.
  Eigen::MatrixXd b;
  /// sensors x states.
  Eigen::MatrixXd c;
  /// sensors x posts.
  Eigen::MatrixXd d;
  Eigen::MatrixXd d_rate;
  Eigen::MatrixXd d_acceleration;
};

}  // namespace fourpost
