#include "vehicles/condensed/state_space.h"

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "vehicles/condensed/linear_vehicle.h"

namespace fourpost {

using Eigen::Index;
using Eigen::MatrixXd;

StateSpace::StateSpace(const CondensedModel& model) {
  const LinearVehicle linear(model, LinearVehicle::Rates::kMean);
  const Index n = model.mass.rows();
  const Index posts = model.post_stiffness.cols();
  a = linear.StateMatrix();
  MatrixXd forces = MatrixXd::Zero(linear.size(), 2 * posts);
  forces.topRows(n) << model.post_stiffness, model.post_damping;
  const MatrixXd by_posts = linear.StateInput(forces);
  const MatrixXd by_heights = by_posts.leftCols(posts);
  const MatrixXd by_velocities = by_posts.rightCols(posts);
  c = model.on_acceleration * a.middleRows(n, n);
  c.leftCols(n) += model.on_position;
  c.middleCols(n, n) += model.on_velocity;
  // With X less by_velocities z in place of the state, z' has gone from its rate.
  b = by_heights + a * by_velocities;
  d = model.on_post_height + model.on_acceleration * by_heights.middleRows(n, n) + c * by_velocities;
  d_rate = model.on_post_velocity + model.on_acceleration * by_velocities.middleRows(n, n);
  d_acceleration = model.on_post_acceleration;
}

MatrixXd StateSpace::ImpulseResponse(const Eigen::VectorXd& shape, double step_s, Index samples) const {
  const MatrixXd step = Exponential(a * step_s);
  Eigen::VectorXd state = b * shape;
  MatrixXd readings(samples, c.rows());
  for (Index k = 0; k < samples; ++k, state = step * state) readings.row(k) = (c * state).transpose();
  return readings;
}

}  // namespace fourpost
