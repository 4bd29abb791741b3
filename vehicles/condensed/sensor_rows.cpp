#include "vehicles/condensed/sensor_rows.h"

#include "vehicles/description/gravity.h"

namespace fourpost {
namespace {

/// Change of an accelerometer's reading with position: the share of gravity that a tilted axis sees.
Eigen::VectorXd GravityTilt(const Kinematics& pose, const Sensor& sensor) {
  const Eigen::Vector3d axis = pose.Rotation(sensor.point.link) * sensor.axis;
  return kGravity * (pose.AngularJacobian(sensor.point.link).transpose() * axis.cross(Eigen::Vector3d::UnitZ()));
}

}  // namespace

void SetSensorRows(const Kinematics& pose, const Vehicle& vehicle, ReducedData& data) {
  const Eigen::Index sensors = static_cast<Eigen::Index>(vehicle.sensors.size());
  data.on_position.setZero(sensors, data.coordinates);
  data.on_velocity.setZero(sensors, data.coordinates);
  data.on_acceleration.setZero(sensors, data.coordinates);
  for (Eigen::Index i = 0; i < sensors; ++i) {
    const Sensor& sensor = vehicle.sensors[static_cast<std::size_t>(i)];
    switch (sensor.type) {
      case Sensor::Type::kAccelerometer:
        data.on_acceleration.row(i) =
            pose.Position(sensor.point, pose.Rotation(sensor.point.link) * sensor.axis).gradient;
        data.on_position.row(i) = GravityTilt(pose, sensor);
        break;
      case Sensor::Type::kDisplacement:
        data.on_position.row(i) = pose.Position(sensor.point, pose.Rotation(sensor.point.link) * sensor.axis).gradient;
        break;
      case Sensor::Type::kStrut: data.on_position.row(i) = pose.LineLength(sensor.line).gradient; break;
      case Sensor::Type::kGyro:
        data.on_velocity.row(i) =
            (pose.Rotation(sensor.point.link) * sensor.axis).transpose() * pose.AngularJacobian(sensor.point.link);
        break;
      case Sensor::Type::kLoadCell: break;
    }
  }
}

}  // namespace fourpost
