#include "vehicles/multibody/body_forces.h"

#include <algorithm>

#include "vehicles/multibody/simbody_bodies.h"
#include "vehicles/multibody/small_turn.h"
#include "vehicles/multibody/tyre_foot.h"

namespace fourpost {
namespace {

using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector_;

Eigen::Matrix3d Rotation(const SimTK::MobilizedBody& body, const State& state) {
  Eigen::Matrix3d rotation;
  const SimTK::Mat33& m = body.getBodyRotation(state).asMat33();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) rotation(i, j) = m(i, j);
  return rotation;
}

Eigen::Vector3d Location(const SimTK::MobilizedBody& body, const Vec3& station, const State& state) {
  return ToEigen(body.findStationLocationInGround(state, station));
}

/// A force at a ground point and a torque on a body.
void Apply(const SimTK::MobilizedBody& body, const State& state, const Eigen::Vector3d& point,
           const Eigen::Vector3d& force, const Eigen::Vector3d& torque, Vector_<SpatialVec>& body_forces) {
  const Eigen::Vector3d arm = point - ToEigen(body.getBodyOriginLocation(state));
  SpatialVec& sum = body_forces[body.getMobilizedBodyIndex()];
  sum[0] += ToSimbody(Eigen::Vector3d(torque + arm.cross(force)));
  sum[1] += ToSimbody(force);
}

/// Places without rates.
Eigen::Matrix<double, 6, 1> Displacement(const BushingData& data, const State& state) {
  const Eigen::Matrix3d axes = Rotation(data.parent, state) * data.parent_axes;
  const Eigen::Vector3d span =
      Location(data.child, data.child_station, state) - Location(data.parent, data.parent_station, state);
  Eigen::Matrix<double, 6, 1> displacement;
  displacement << axes.transpose() * span - data.design_place,
      SmallTurn(axes.transpose() * Rotation(data.child, state) * data.child_axes).value;
  return displacement;
}

/// How far the foot has moved from where it stands in the design pose, relative to the platform, and how fast.
struct FootMotion {
  TyreFoot foot;
  Eigen::Vector3d centre;
  Eigen::Vector3d shift;
  Eigen::Vector3d shift_rate;
};

PostState PlatformOf(const TyreData& data, const Platforms& platforms) {
  return data.post < 0 ? PostState() : platforms[static_cast<std::size_t>(data.post)];
}

Eigen::Vector3d FootShift(const TyreData& data, const Platforms& platforms, const State& state) {
  const TyreFoot foot(Rotation(data.body, state), data.radius);
  const Eigen::Vector3d platform(0, 0, PlatformOf(data, platforms).height);
  return Location(data.body, data.station, state) + foot.offset - data.design_place - platform;
}

FootMotion MotionOf(const TyreData& data, const Platforms& platforms, const State& state) {
  const TyreFoot foot(Rotation(data.body, state), data.radius);
  const Eigen::Vector3d centre = Location(data.body, data.station, state);
  const PostState post = PlatformOf(data, platforms);
  const Eigen::Vector3d velocity = ToEigen(data.body.findStationVelocityInGround(state, data.station)) +
                                   foot.rate * ToEigen(data.body.getBodyAngularVelocity(state));
  return {foot, centre, centre + foot.offset - data.design_place - Eigen::Vector3d(0, 0, post.height),
          velocity - Eigen::Vector3d(0, 0, post.velocity)};
}

double Compression(const TyreData& data, const FootMotion& motion) {
  const double force = data.vertical.Force(-motion.shift.z()) - data.damping * motion.shift_rate.z();
  return data.lifts_off ? std::max(0.0, force) : force;
}

}  // namespace

BushingMotion Motion(const BushingData& data, const State& state) {
  BushingMotion motion;
  motion.axes = Rotation(data.parent, state) * data.parent_axes;
  const Eigen::Vector3d child = Location(data.child, data.child_station, state);
  const Vec3 on_parent = data.parent.findStationAtGroundPoint(state, ToSimbody(child));
  const Eigen::Vector3d velocity = ToEigen(data.child.findStationVelocityInGround(state, data.child_station) -
                                           data.parent.findStationVelocityInGround(state, on_parent));
  const Eigen::Vector3d spin =
      ToEigen(data.child.getBodyAngularVelocity(state) - data.parent.getBodyAngularVelocity(state));
  const SmallTurn turn(motion.axes.transpose() * Rotation(data.child, state) * data.child_axes);
  motion.turn_rate = turn.rate;
  motion.displacement << motion.axes.transpose() * (child - Location(data.parent, data.parent_station, state)) -
                             data.design_place,
      turn.value;
  motion.rate << motion.axes.transpose() * velocity, turn.rate * (motion.axes.transpose() * spin);
  return motion;
}

void MeasureDesign(BushingData& data, const State& state) {
  data.child_axes = Rotation(data.child, state).transpose() * Rotation(data.parent, state) * data.parent_axes;
  data.design_place.setZero();
  data.design_place = Displacement(data, state).head<3>();
}

void BushingForce::calcForce(const State& state, Vector_<SpatialVec>& body_forces, Vector_<Vec3>&,
                             SimTK::Vector&) const {
  const BushingMotion motion = Motion(data_, state);
  Eigen::Matrix<double, 6, 1> resistance;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const auto k = static_cast<std::size_t>(i);
    resistance[i] = data_.stiffness[k] * motion.displacement[i] + data_.damping[k] * motion.rate[i];
  }
  resistance.head<3>() += data_.preload;
  const Eigen::Vector3d force = -(motion.axes * resistance.head<3>());
  const Eigen::Vector3d torque = -(motion.axes * (motion.turn_rate.transpose() * resistance.tail<3>()));
  const Eigen::Vector3d point = Location(data_.child, data_.child_station, state);
  Apply(data_.child, state, point, force, torque, body_forces);
  Apply(data_.parent, state, point, -force, -torque, body_forces);
}

SimTK::Real BushingForce::calcPotentialEnergy(const State& state) const {
  const Eigen::Matrix<double, 6, 1> displacement = Displacement(data_, state);
  double energy = data_.preload.dot(displacement.head<3>());
  for (Eigen::Index i = 0; i < 6; ++i)
    energy += 0.5 * data_.stiffness[static_cast<std::size_t>(i)] * displacement[i] * displacement[i];
  return energy;
}

void MeasureDesign(TyreData& data, const State& state) {
  data.design_place =
      Location(data.body, data.station, state) + TyreFoot(Rotation(data.body, state), data.radius).offset;
}

double TyreForce::Compression(const TyreData& data, const Platforms& platforms, const State& state) {
  return fourpost::Compression(data, MotionOf(data, platforms, state));
}

void TyreForce::calcForce(const State& state, Vector_<SpatialVec>& body_forces, Vector_<Vec3>&, SimTK::Vector&) const {
  const FootMotion motion = MotionOf(data_, platforms_(state.getTime()), state);
  const Eigen::Vector3d& rate = motion.shift_rate;
  const Eigen::Vector3d force(-data_.longitudinal * motion.shift.x() - data_.longitudinal_damping * rate.x(),
                              -data_.lateral * motion.shift.y() - data_.lateral_damping * rate.y(),
                              fourpost::Compression(data_, motion));
  Apply(data_.body, state, motion.centre, force, motion.foot.rate.transpose() * force, body_forces);
}

SimTK::Real TyreForce::calcPotentialEnergy(const State& state) const {
  const Eigen::Vector3d shift = FootShift(data_, platforms_(state.getTime()), state);
  const double plane = 0.5 * (data_.longitudinal * shift.x() * shift.x() + data_.lateral * shift.y() * shift.y());
  // Where a tyre leaves its platform its energy stays at the least.
  const LoadedTyre& vertical = data_.vertical;
  const bool is_lifted = data_.lifts_off && vertical.Force(-shift.z()) < 0;
  if (is_lifted) return vertical.Rate(0) > 0 ? plane + vertical.Energy(vertical.Liftoff()) : plane;
  return plane + vertical.Energy(-shift.z());
}

}  // namespace fourpost
