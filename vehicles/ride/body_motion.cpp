#include "vehicles/ride/body_motion.h"

namespace fourpost {
namespace {

/// For each link the first of those that fixed joints hold it to.
std::vector<int> FirstLinks(const Vehicle& vehicle) {
  std::vector<int> first(vehicle.links.size());
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = static_cast<int>(i);
  for (const Joint& joint : vehicle.joints)
    if (joint.type == Joint::Type::kFixed)
      first[static_cast<std::size_t>(joint.child)] = first[static_cast<std::size_t>(joint.parent)];
  return first;
}

MassProperties PropertiesOf(const Link& link, int index, const Kinematics& pose, std::span<const double> parameters) {
  const auto moment = [&](std::size_t i) { return link.inertia[i].At(parameters); };
  Eigen::Matrix3d inertia;
  inertia << moment(0), moment(3), moment(4), moment(3), moment(1), moment(5), moment(4), moment(5), moment(2);
  const Eigen::Matrix3d axes = pose.Rotation(index);
  return {link.mass.At(parameters), pose.Location({index, link.ComAt(parameters)}), axes * inertia * axes.transpose()};
}

/// Inertia about `centre` of a point mass at `place`.
Eigen::Matrix3d PointInertia(double mass, const Eigen::Vector3d& place, const Eigen::Vector3d& centre) {
  const Eigen::Vector3d arm = place - centre;
  return mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
}

BodyMotion MotionOf(const Vehicle& vehicle, const std::vector<int>& links, const Kinematics& pose,
                    std::span<const double> parameters) {
  BodyMotion body;
  body.links = links;
  std::vector<MassProperties> parts;
  double heaviest = -1;
  for (const int index : links) {
    const Link& link = vehicle.links[static_cast<std::size_t>(index)];
    parts.push_back(PropertiesOf(link, index, pose, parameters));
    if (parts.back().mass <= heaviest) continue;
    heaviest = parts.back().mass;
    body.name = link.name;
  }
  body.mass = Joined(parts);
  const int first = links.front();
  const Eigen::Vector3d origin = pose.Location({first, Eigen::Vector3d::Zero()});
  body.com_jacobian = pose.PointJacobian({first, pose.Rotation(first).transpose() * (body.mass.com - origin)});
  body.spin_jacobian = pose.AngularJacobian(first);
  return body;
}

}  // namespace

MassProperties Joined(std::span<const MassProperties> bodies) {
  MassProperties whole;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const MassProperties& body : bodies) {
    whole.mass += body.mass;
    whole.com += body.mass * body.com;
    middle += body.com / static_cast<double>(bodies.size());
  }
  if (whole.mass > 0) whole.com /= whole.mass;
  else whole.com = middle;
  for (const MassProperties& body : bodies)
    whole.inertia += body.inertia + PointInertia(body.mass, body.com, whole.com);
  return whole;
}

std::vector<BodyMotion> BodyMotions(const Vehicle& vehicle, const Kinematics& pose,
                                    std::span<const double> parameters) {
  const std::vector<int> first = FirstLinks(vehicle);
  std::vector<BodyMotion> bodies;
  for (std::size_t i = 1; i < vehicle.links.size(); ++i) {
    if (first[i] != static_cast<int>(i)) continue;
    std::vector<int> links;
    for (std::size_t k = 1; k < vehicle.links.size(); ++k)
      if (first[k] == first[i]) links.push_back(static_cast<int>(k));
    BodyMotion body = MotionOf(vehicle, links, pose, parameters);
    if (body.mass.mass > 0 || !body.mass.inertia.isZero(0)) bodies.push_back(std::move(body));
  }
  return bodies;
}

Eigen::Matrix<double, 6, 1> EnergyByDirection(const BodyMotion& body, const Eigen::VectorXcd& shape) {
  const Eigen::Vector3cd velocity = body.com_jacobian * shape;
  const Eigen::Vector3cd spin = body.spin_jacobian * shape;
  const Eigen::Vector3cd momentum = body.mass.inertia * spin;
  Eigen::Matrix<double, 6, 1> energy;
  energy << body.mass.mass * velocity.cwiseAbs2(), spin.conjugate().cwiseProduct(momentum).real();
  return energy;
}

}  // namespace fourpost
