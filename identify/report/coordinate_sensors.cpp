#include "identify/report/coordinate_sensors.h"

namespace fourpost {

std::vector<Sensor> CoordinateSensors(const CondensedModel& model) {
  return std::vector<Sensor>(static_cast<std::size_t>(model.mass.rows()), Sensor{.type = Sensor::Type::kDisplacement});
}

CondensedModel WithCoordinatesAsSensors(CondensedModel model) {
  const Eigen::Index n = model.mass.rows();
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(n, n);
  const Eigen::MatrixXd no_post = Eigen::MatrixXd::Zero(n, model.post_stiffness.cols());
  model.on_position = Eigen::MatrixXd::Identity(n, n);
  model.on_velocity = model.on_acceleration = none;
  model.on_post_height = model.on_post_velocity = model.on_post_acceleration = no_post;
  for (CondensedModel::Liftoff& liftoff : model.liftoffs) liftoff.load_cells.clear();
  for (CondensedModel::CurvedTyre& tyre : model.curved_tyres) tyre.load_cells.clear();
  return model;
}

}  // namespace fourpost
