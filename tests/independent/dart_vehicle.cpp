#include "tests/independent/dart_vehicle.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace fourpost {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

bool IsWrittenOut(const Damper& damper) {
  const DashpotDescription& law = damper.law;
  return law.kind == DashpotDescription::Kind::kBilinear && !law.friction && !damper.series && !damper.hydraulic;
}

void Refuse(const std::string& element) {
  throw std::invalid_argument("DartVehicle: " + element + " has a law that is not written out");
}

/// Up in the plane of a wheel: u = w / |w|, w = z - (z . a) a, a: the wheel's axis.
Vector3d UpWheel(const Vector3d& axis) { return (Vector3d::UnitZ() - axis.z() * axis).normalized(); }

/// du/dt of a wheel that turns at `spin`: a' = spin x a.
Vector3d UpWheelRate(const Vector3d& axis, const Vector3d& spin) {
  const Vector3d axis_rate = spin.cross(axis);
  const Vector3d w = Vector3d::UnitZ() - axis.z() * axis;
  const Vector3d w_rate = -axis_rate.z() * axis - axis.z() * axis_rate;
  const Vector3d u = w.normalized();
  return (w_rate - u.dot(w_rate) * u) / w.norm();
}

PostState PlatformUnder(const Vehicle& vehicle, std::size_t tyre, std::span<const PostState> posts) {
  for (std::size_t i = 0; i < vehicle.posts.size(); ++i)
    if (vehicle.posts[i].tyre == static_cast<int>(tyre)) return posts[i];
  return {};
}

}  // namespace

DartVehicle::DartVehicle(const Vehicle& vehicle, const Preloads& preloads)
    : vehicle_(vehicle), preloads_(preloads), parameters_(vehicle.ParameterValues()), tree_(vehicle) {
  RefuseUnknown();
  MeasureDesign();
}

void DartVehicle::RefuseUnknown() const {
  if (vehicle_.HasLoops()) throw std::invalid_argument("DartVehicle: the vehicle has loop closures");
  for (const Spring& spring : vehicle_.springs)
    if (!spring.law.knees.empty()) Refuse(spring.Element());
  for (const Damper& damper : vehicle_.dampers)
    if (!IsWrittenOut(damper)) Refuse("fp:damper '" + damper.name + "'");
}

/// DART's coordinates are zero at first.
void DartVehicle::MeasureDesign() {
  for (const Spring& spring : vehicle_.springs) spring_lengths_.push_back(Motion(spring.line).length);
  for (const AntiRollBar& bar : vehicle_.antiroll_bars)
    bar_differences_.push_back(Motion(bar.left).length - Motion(bar.right).length);
  for (const Bushing& bushing : vehicle_.bushings) bushings_.push_back(ChildInBushing(bushing));
  for (const Tyre& tyre : vehicle_.tyres) feet_.push_back(Foot(tyre));
}

Eigen::VectorXd DartVehicle::StateDerivative(const Eigen::VectorXd& state, std::span<const PostState> posts) {
  const Eigen::Index n = state.size() / 2;
  tree_.SetState(state.head(n), state.tail(n));
  ApplyElements(posts);
  Eigen::VectorXd derivative(2 * n);
  derivative << state.tail(n), tree_.Accelerations();
  return derivative;
}

void DartVehicle::ApplyElements(std::span<const PostState> posts) {
  for (std::size_t i = 0; i < vehicle_.springs.size(); ++i)
    Apply(vehicle_.springs[i], preloads_.spring[i], spring_lengths_[i]);
  for (const Damper& damper : vehicle_.dampers) Apply(damper);
  for (std::size_t i = 0; i < vehicle_.antiroll_bars.size(); ++i) Apply(vehicle_.antiroll_bars[i], bar_differences_[i]);
  for (std::size_t i = 0; i < vehicle_.bushings.size(); ++i)
    Apply(vehicle_.bushings[i], preloads_.bushing[i], bushings_[i]);
  for (std::size_t i = 0; i < vehicle_.tyres.size(); ++i)
    Apply(vehicle_.tyres[i], preloads_.tyre[i], feet_[i], PlatformUnder(vehicle_, i, posts));
}

DartVehicle::LineMotion DartVehicle::Motion(const ForceLine& line) const {
  const Vector3d parent = tree_.Place(line.parent);
  const Vector3d child = tree_.Place(line.child);
  const Vector3d span = parent - child;
  const Vector3d span_rate = tree_.Velocity(line.parent) - tree_.Velocity(line.child);
  if (!line.axis) {
    const Vector3d along = span.normalized();
    return {parent, child, along, span.norm(), along.dot(span_rate)};
  }
  const Vector3d axis = tree_.Rotation(line.parent.link) * *line.axis;
  const Vector3d axis_rate = tree_.Spin(line.parent.link).cross(axis);
  return {child, child, axis, axis.dot(span), axis.dot(span_rate) + axis_rate.dot(span)};
}

void DartVehicle::Pull(const ForceLine& line, const LineMotion& motion, double tension) {
  tree_.Push(line.child.link, motion.on_child, tension * motion.pull);
  tree_.Push(line.parent.link, motion.on_parent, -tension * motion.pull);
}

void DartVehicle::Apply(const Spring& spring, double preload, double design_length) {
  const LineMotion motion = Motion(spring.line);
  const double x = motion.length - design_length;
  const double stiffness = spring.law.stiffness.At(parameters_);
  Pull(spring.line, motion, preload + stiffness * x + spring.law.cubic.At(parameters_) * x * x * x);
}

void DartVehicle::Apply(const Damper& damper) {
  const LineMotion motion = Motion(damper.line);
  const Scalar& rate = motion.rate > 0 ? damper.law.rebound : damper.law.compression;
  Pull(damper.line, motion, rate.At(parameters_) * motion.rate);
}

void DartVehicle::Apply(const AntiRollBar& bar, double design_difference) {
  const LineMotion left = Motion(bar.left);
  const LineMotion right = Motion(bar.right);
  const double tension = bar.stiffness.At(parameters_) * (left.length - right.length - design_difference) +
                         bar.damping.At(parameters_) * (left.rate - right.rate);
  Pull(bar.left, left, tension);
  Pull(bar.right, right, -tension);
}

Eigen::Isometry3d DartVehicle::ChildInBushing(const Bushing& bushing) const {
  const Matrix3d axes = tree_.Rotation(bushing.parent.link) * bushing.axes;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = axes.transpose() * tree_.Rotation(bushing.child.link);
  pose.translation() = axes.transpose() * (tree_.Place(bushing.child) - tree_.Place(bushing.parent));
  return pose;
}

void DartVehicle::Apply(const Bushing& bushing, const Vector3d& preload, const Eigen::Isometry3d& design) {
  const int parent = bushing.parent.link;
  const int child = bushing.child.link;
  const Matrix3d axes = tree_.Rotation(parent) * bushing.axes;
  const Eigen::Isometry3d pose = ChildInBushing(bushing);
  const Vector3d spin = axes.transpose() * (tree_.Spin(child) - tree_.Spin(parent));
  Eigen::Quaterniond turn(pose.linear() * design.linear().transpose());
  if (turn.w() < 0) turn.coeffs() *= -1;
  const Vector3d place = tree_.Place(bushing.child);
  const Vector3d span_rate = tree_.Velocity(bushing.child) - tree_.Velocity(bushing.parent) -
                             tree_.Spin(parent).cross(place - tree_.Place(bushing.parent));

  // Quaternion (s, v) at the angular velocity w: 2 v' = s w + w x v.
  Eigen::Matrix<double, 6, 1> displacement;
  Eigen::Matrix<double, 6, 1> rate;
  displacement << pose.translation() - design.translation(), 2 * turn.vec();
  rate << axes.transpose() * span_rate, turn.w() * spin + spin.cross(turn.vec());
  Eigen::Matrix<double, 6, 1> resistance;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const auto k = static_cast<std::size_t>(i);
    resistance[i] =
        bushing.stiffness[k].At(parameters_) * displacement[i] + bushing.DampingAt(k, parameters_) * rate[i];
  }
  const Vector3d force = -(axes * (preload + resistance.head<3>()));
  // Of the same power: m . (s w + w x v) = w . (s m + v x m).
  const Vector3d moment = resistance.tail<3>();
  const Vector3d torque = -(axes * (turn.w() * moment + turn.vec().cross(moment)));
  tree_.Push(child, place, force);
  tree_.Push(parent, place, -force);
  tree_.Turn(child, torque);
  tree_.Turn(parent, -torque);
}

Vector3d DartVehicle::Foot(const Tyre& tyre) const {
  return tree_.Place(tyre.point) - tyre.radius * UpWheel(tree_.Rotation(tyre.point.link).col(1));
}

void DartVehicle::Apply(const Tyre& tyre, double preload, const Vector3d& design_foot, const PostState& platform) {
  const int wheel = tyre.point.link;
  const Vector3d axis = tree_.Rotation(wheel).col(1);
  const Vector3d shift = Foot(tyre) - design_foot - platform.height * Vector3d::UnitZ();
  const Vector3d rate = tree_.Velocity(tyre.point) - tyre.radius * UpWheelRate(axis, tree_.Spin(wheel)) -
                        platform.velocity * Vector3d::UnitZ();
  double load = tyre.law.At(parameters_).Under(preload).Force(-shift.z()) - tyre.damping.At(parameters_) * rate.z();
  if (tyre.lifts_off || !tyre.law.IsLinear()) load = std::max(load, 0.0);
  const Vector3d force(
      -tyre.longitudinal.At(parameters_) * shift.x() - tyre.longitudinal_damping.At(parameters_) * rate.x(),
      -tyre.lateral.At(parameters_) * shift.y() - tyre.lateral_damping.At(parameters_) * rate.y(), load);
  tree_.Push(wheel, tree_.Place(tyre.point), force);
  // The foot moves about the centre as the wheel leans, not as a point of the wheel: its power at each unit of spin.
  Vector3d torque;
  for (int i = 0; i < 3; ++i) torque[i] = -tyre.radius * force.dot(UpWheelRate(axis, Vector3d::Unit(i)));
  tree_.Turn(wheel, torque);
}

}  // namespace fourpost
