#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/Skeleton.hpp>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Links and joints of a vehicle as a DART skeleton, at the file's values of the parameters. Nothing of it comes from
/// Multibody, whose coordinates it has: those of the joints in the order of Vehicle::joints, for a floating joint the
/// body-fixed x-y-z angles of DART's Euler joint and then the travels of the translational joint that carries it.
class DartTree {
 public:
  /// Throws std::invalid_argument for a planar joint.
  explicit DartTree(const Vehicle& vehicle);
  DartTree(const DartTree&) = delete;
  DartTree& operator=(const DartTree&) = delete;

  /// Joint coordinates and their rates; takes away all forces but gravity.
  void SetState(const Eigen::VectorXd& q, const Eigen::VectorXd& u);

  // In ground axes; link 0 is the ground, at rest.
  Eigen::Vector3d Place(const Point& point) const;
  Eigen::Vector3d Velocity(const Point& point) const;
  Eigen::Matrix3d Rotation(int link) const;
  Eigen::Vector3d Spin(int link) const;
  /// Adds a force [N] that acts on a link at a place.
  void Push(int link, const Eigen::Vector3d& place, const Eigen::Vector3d& force);
  /// Adds a torque [N m].
  void Turn(int link, const Eigen::Vector3d& torque);

  // M(q) u' + velocity forces(q, u) + gravity forces(q) = forces that were added.
  Eigen::MatrixXd MassMatrix() const;
  Eigen::VectorXd VelocityForces() const;
  Eigen::VectorXd GravityForces() const;
  /// u' by DART's articulated-body recursion, which takes no mass matrix.
  Eigen::VectorXd Accelerations();

 private:
  template <typename JointType>
  JointType& AddBody(dart::dynamics::BodyNode* parent, const std::string& name, const Eigen::Isometry3d& pose,
                     const dart::dynamics::Inertia& inertia);
  void AddLink(const Joint& joint, const dart::dynamics::Inertia& inertia);
  void NumberCoordinates(const Vehicle& vehicle);
  const dart::dynamics::Frame& Frame(int link) const;
  dart::dynamics::BodyNode* Body(int link) const { return bodies_[static_cast<std::size_t>(link)]; }

  dart::dynamics::SkeletonPtr skeleton_ = dart::dynamics::Skeleton::create();
  /// nullptr for the ground, as DART takes it.
  std::vector<dart::dynamics::BodyNode*> bodies_;
  /// DART's number of each of our coordinates.
  std::vector<std::size_t> coordinates_;
};

}  // namespace fourpost
