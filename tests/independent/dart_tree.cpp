#include "tests/independent/dart_tree.h"

#include <array>
#include <span>
#include <stdexcept>
#include <string>

#include <dart/dynamics/EulerJoint.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/TranslationalJoint.hpp>
#include <dart/dynamics/WeldJoint.hpp>

#include "vehicles/description/gravity.h"

namespace fourpost {
namespace {

using dart::dynamics::BodyNode;
using dart::dynamics::EulerJoint;
using dart::dynamics::Inertia;
using dart::dynamics::PrismaticJoint;
using dart::dynamics::RevoluteJoint;
using dart::dynamics::TranslationalJoint;
using dart::dynamics::WeldJoint;

/// Mass [kg] or moment of inertia [kg m^2] as good as none: DART warns of bodies without, and any other absorbs it.
constexpr double kNone = 1e-30;

Inertia InertiaOf(const Link& link, std::span<const double> parameters) {
  std::array<double, 6> i{};
  for (std::size_t k = 0; k < i.size(); ++k) i[k] = link.inertia[k].At(parameters);
  Eigen::Matrix3d moment;
  moment << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
  return {link.mass.At(parameters) + kNone, link.ComAt(parameters), moment + kNone * Eigen::Matrix3d::Identity()};
}

Inertia Massless() { return {kNone, Eigen::Vector3d::Zero(), kNone * Eigen::Matrix3d::Identity()}; }

}  // namespace

template <typename JointType>
JointType& DartTree::AddBody(BodyNode* parent, const std::string& name, const Eigen::Isometry3d& pose,
                             const Inertia& inertia) {
  typename JointType::Properties properties;
  properties.mName = name;
  properties.mT_ParentBodyToJoint = pose;
  const auto [joint, body] = skeleton_->createJointAndBodyNodePair<JointType>(
      parent, properties, BodyNode::Properties(BodyNode::AspectProperties(name)));
  body->setInertia(inertia);
  return *joint;
}

DartTree::DartTree(const Vehicle& vehicle) : bodies_(vehicle.links.size(), nullptr) {
  skeleton_->setGravity({0, 0, -kGravity});
  const std::vector<double> parameters = vehicle.ParameterValues();
  for (const Joint& joint : vehicle.joints)
    AddLink(joint, InertiaOf(vehicle.links[static_cast<std::size_t>(joint.child)], parameters));
  NumberCoordinates(vehicle);
}

void DartTree::AddLink(const Joint& joint, const Inertia& inertia) {
  BodyNode* parent = Body(joint.parent);
  switch (joint.type) {
    case Joint::Type::kFixed: AddBody<WeldJoint>(parent, joint.name, joint.pose, inertia); break;
    case Joint::Type::kRevolute:
      AddBody<RevoluteJoint>(parent, joint.name, joint.pose, inertia).setAxis(joint.axis);
      break;
    case Joint::Type::kPrismatic:
      AddBody<PrismaticJoint>(parent, joint.name, joint.pose, inertia).setAxis(joint.axis);
      break;
    case Joint::Type::kFloating: {
      const std::string carrier = joint.name + " translation";
      AddBody<TranslationalJoint>(parent, carrier, joint.pose, Massless());
      AddBody<EulerJoint>(skeleton_->getBodyNode(carrier), joint.name, Eigen::Isometry3d::Identity(), inertia)
          .setAxisOrder(EulerJoint::AxisOrder::XYZ);
      break;
    }
    case Joint::Type::kPlanar: throw std::invalid_argument("DartTree: joint '" + joint.name + "' is planar");
  }
  bodies_[static_cast<std::size_t>(joint.child)] = skeleton_->getBodyNode(joint.name);
}

/// A joint's own coordinates are DART's of its last joint; those of a floating one go on with its carrier's.
void DartTree::NumberCoordinates(const Vehicle& vehicle) {
  const auto add = [this](const dart::dynamics::Joint* joint) {
    for (std::size_t i = 0; i < joint->getNumDofs(); ++i) coordinates_.push_back(joint->getIndexInSkeleton(i));
  };
  for (const Joint& joint : vehicle.joints) {
    const BodyNode* body = Body(joint.child);
    add(body->getParentJoint());
    if (joint.type == Joint::Type::kFloating) add(body->getParentBodyNode()->getParentJoint());
  }
}

void DartTree::SetState(const Eigen::VectorXd& q, const Eigen::VectorXd& u) {
  skeleton_->setPositions(coordinates_, q);
  skeleton_->setVelocities(coordinates_, u);
  skeleton_->clearExternalForces();
}

const dart::dynamics::Frame& DartTree::Frame(int link) const {
  return link == 0 ? *dart::dynamics::Frame::World() : *Body(link);
}

Eigen::Vector3d DartTree::Place(const Point& point) const { return Frame(point.link).getTransform() * point.xyz; }

Eigen::Vector3d DartTree::Velocity(const Point& point) const { return Frame(point.link).getLinearVelocity(point.xyz); }

Eigen::Matrix3d DartTree::Rotation(int link) const { return Frame(link).getTransform().linear(); }

Eigen::Vector3d DartTree::Spin(int link) const { return Frame(link).getAngularVelocity(); }

void DartTree::Push(int link, const Eigen::Vector3d& place, const Eigen::Vector3d& force) {
  BodyNode* body = Body(link);
  if (body) body->addExtForce(force, body->getTransform().inverse() * place);
}

void DartTree::Turn(int link, const Eigen::Vector3d& torque) {
  BodyNode* body = Body(link);
  if (body) body->addExtTorque(torque);
}

Eigen::MatrixXd DartTree::MassMatrix() const { return skeleton_->getMassMatrix()(coordinates_, coordinates_); }

Eigen::VectorXd DartTree::VelocityForces() const { return skeleton_->getCoriolisForces()(coordinates_); }

Eigen::VectorXd DartTree::GravityForces() const { return skeleton_->getGravityForces()(coordinates_); }

Eigen::VectorXd DartTree::Accelerations() {
  skeleton_->computeForwardDynamics();
  return skeleton_->getAccelerations(coordinates_);
}

}  // namespace fourpost
