#include "vehicles/closed_form/half_car.h"

namespace fourpost {

CondensedModel HalfCar::Model() const {
  // Extensions: delta_f = z_s - l_f theta - z_f, delta_r = z_s + l_r theta - z_r.
  const Eigen::Vector4d front(1, -front_length, -1, 0);
  const Eigen::Vector4d rear(1, rear_length, 0, -1);
  CondensedModel model;
  model.mass = Eigen::Vector4d(sprung_mass, pitch_inertia, front_mass, rear_mass).asDiagonal();
  model.damping = Eigen::Matrix4d::Zero();
  model.stiffness = front_stiffness * front * front.transpose() + rear_stiffness * rear * rear.transpose();
  model.stiffness(2, 2) += front_tyre_stiffness;
  model.stiffness(3, 3) += rear_tyre_stiffness;
  model.post_stiffness = Eigen::MatrixXd::Zero(4, 2);
  model.post_stiffness(2, 0) = front_tyre_stiffness;
  model.post_stiffness(3, 1) = rear_tyre_stiffness;
  model.post_damping = Eigen::MatrixXd::Zero(4, 2);
  model.dashpots = {{front, front_damper, {}}, {rear, rear_damper, {}}};
  return model;
}

Eigen::Vector4d HalfCar::Acceleration(const Eigen::Vector4d& q, const Eigen::Vector4d& rate,
                                      const Eigen::Vector2d& ground) const {
  return HalfCarAcceleration<double>(*this, q, rate, ground);
}

}  // namespace fourpost
