#include "vehicles/ride/suspension.h"

#include <algorithm>

#include "vehicles/description/chassis.h"

namespace fourpost {
namespace {

Wheel WheelOf(const Vehicle& vehicle, const Tyre& tyre, const Kinematics& pose) {
  Wheel wheel;
  wheel.name = tyre.name;
  wheel.link = tyre.point.link;
  const Joint* const spin = SpinOf(vehicle, tyre);
  wheel.carrier = spin ? spin->parent : wheel.link;
  for (Eigen::Index i = 0; i < 3; ++i) wheel.foot[i] = pose.FootPosition(tyre, Eigen::Vector3d::Unit(i)).value;
  wheel.foot_rise = pose.FootPosition(tyre, Eigen::Vector3d::UnitZ()).gradient;
  wheel.jacobian.resize(6, wheel.foot_rise.size());
  wheel.jacobian << pose.PointJacobian(tyre.point), pose.AngularJacobian(tyre.point.link);
  return wheel;
}

int ChassisOf(const std::vector<BodyMotion>& bodies, const std::vector<Wheel>& wheels) {
  std::vector<TyreCarrier> carriers;
  for (const BodyMotion& body : bodies) {
    carriers.push_back({.mass = body.mass.mass, .stations = {}});
    for (const Wheel& wheel : wheels)
      if (std::find(body.links.begin(), body.links.end(), wheel.link) != body.links.end())
        carriers.back().stations.push_back(wheel.foot.x());
  }
  return ChassisOf(carriers);
}

std::vector<Axle> AxlesOf(const std::vector<Wheel>& wheels) {
  std::vector<std::size_t> order(wheels.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return wheels[a].foot.x() > wheels[b].foot.x(); });
  std::vector<Axle> axles;
  for (const std::size_t i : order) {
    if (axles.empty() || wheels[axles.back().wheels.front()].foot.x() - wheels[i].foot.x() > kSameStation_m)
      axles.push_back({});
    axles.back().wheels.push_back(i);
  }
  for (std::size_t i = 0; i < axles.size(); ++i) {
    axles[i].name = i == 0 ? "front" : i + 1 == axles.size() ? "rear" : "axle " + std::to_string(i + 1);
    std::sort(axles[i].wheels.begin(), axles[i].wheels.end());
  }
  if (axles.size() == 1) axles.front().name = "wheel";
  return axles;
}

void FindSides(const Axle& axle, std::vector<Wheel>& wheels) {
  // Less than any track: wheels one above the other, as in a plane model.
  constexpr double kSameSide_m = 0.1;
  double middle = 0;
  for (const std::size_t i : axle.wheels) middle += wheels[i].foot.y() / static_cast<double>(axle.wheels.size());
  for (const std::size_t i : axle.wheels) {
    const double aside = wheels[i].foot.y() - middle;
    wheels[i].side = aside > kSameSide_m ? 1 : aside < -kSameSide_m ? -1 : 0;
  }
}

}  // namespace

const Joint* SpinOf(const Vehicle& vehicle, const Tyre& tyre) {
  constexpr double kOnAxis_m = 1e-6;  // digits of a file
  for (const Joint& joint : vehicle.joints)
    if (joint.child == tyre.point.link && joint.type == Joint::Type::kRevolute && joint.parent != 0 &&
        joint.axis.cross(tyre.point.xyz).norm() < kOnAxis_m &&
        joint.axis.cross(Eigen::Vector3d::UnitY()).norm() < kOnAxis_m)
      return &joint;
  return nullptr;
}

Suspension SuspensionOf(const Vehicle& vehicle, const Kinematics& pose, std::span<const double> parameters) {
  Suspension suspension;
  suspension.bodies = BodyMotions(vehicle, pose, parameters);
  for (const Tyre& tyre : vehicle.tyres) suspension.wheels.push_back(WheelOf(vehicle, tyre, pose));
  suspension.chassis = ChassisOf(suspension.bodies, suspension.wheels);
  suspension.axles = AxlesOf(suspension.wheels);
  for (const Axle& axle : suspension.axles) FindSides(axle, suspension.wheels);
  return suspension;
}

}  // namespace fourpost
