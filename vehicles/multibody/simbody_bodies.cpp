#include "vehicles/multibody/simbody_bodies.h"

#include <array>
#include <stdexcept>

namespace fourpost {
namespace {

using SimTK::MobilizedBody;
using SimTK::Transform;
using SimTK::Vec3;

/// A frame whose given axis points along `direction`.
Transform Aligned(const Eigen::Vector3d& direction, const SimTK::CoordinateAxis& axis) {
  return {SimTK::Rotation(SimTK::UnitVec3(ToSimbody(direction)), axis), Vec3(0)};
}

}  // namespace

SimTK::Vec3 ToSimbody(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Eigen::Vector3d ToEigen(const Vec3& v) { return {v[0], v[1], v[2]}; }

Transform ToSimbody(const Eigen::Isometry3d& pose) {
  SimTK::Mat33 rotation;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) rotation(i, j) = pose.linear()(i, j);
  return {SimTK::Rotation(rotation), ToSimbody(Eigen::Vector3d(pose.translation()))};
}

Eigen::Isometry3d ToEigen(const Transform& transform) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) pose.linear()(i, j) = transform.R().asMat33()(i, j);
  pose.translation() = ToEigen(transform.p());
  return pose;
}

Eigen::VectorXd ToEigen(const SimTK::Vector& v) {
  Eigen::VectorXd out(v.size());
  for (int i = 0; i < v.size(); ++i) out[i] = v[i];
  return out;
}

Eigen::MatrixXd ToEigen(const SimTK::Matrix& m) {
  Eigen::MatrixXd out(m.nrow(), m.ncol());
  for (int i = 0; i < m.nrow(); ++i)
    for (int j = 0; j < m.ncol(); ++j) out(i, j) = m(i, j);
  return out;
}

SimTK::MassProperties MassPropertiesAt(const Link& link, std::span<const double> parameters) {
  const double mass = link.mass.At(parameters);
  const Vec3 com = ToSimbody(link.ComAt(parameters));
  std::array<double, 6> i{};
  for (std::size_t k = 0; k < i.size(); ++k) i[k] = link.inertia[k].At(parameters);
  // Simbody takes the central inertia back as a difference and refuses what rounding leaves below zero of a point mass.
  const double rounding = 16 * SimTK::Eps * mass * com.normSqr();
  const SimTK::Inertia central(i[0] + rounding, i[1] + rounding, i[2] + rounding, i[3], i[4], i[5]);
  return {mass, com, mass > 0 ? central.shiftFromMassCenter(com, mass) : central};
}

MobilizedBody AddMobilizer(const Joint& joint, MobilizedBody& parent, const SimTK::Body& body) {
  const Transform pose = ToSimbody(joint.pose);
  switch (joint.type) {
    case Joint::Type::kFixed: return MobilizedBody::Weld(parent, pose, body, Transform());
    case Joint::Type::kRevolute: {
      const Transform axis = Aligned(joint.axis, SimTK::ZAxis);
      return MobilizedBody::Pin(parent, pose * axis, body, axis);
    }
    case Joint::Type::kPrismatic: {
      const Transform axis = Aligned(joint.axis, SimTK::XAxis);
      return MobilizedBody::Slider(parent, pose * axis, body, axis);
    }
    case Joint::Type::kPlanar: {
      const Transform normal = Aligned(joint.axis, SimTK::ZAxis);
      return MobilizedBody::Planar(parent, pose * normal, body, normal);
    }
    case Joint::Type::kFloating: return MobilizedBody::Bushing(parent, pose, body, Transform());
  }
  throw std::logic_error("joint type without a mobilizer");
}

}  // namespace fourpost
