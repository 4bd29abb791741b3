#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/kinematics.h"

namespace fourpost {

/// In ground axes: mass [kg], centre of mass [m], inertia about it [kg m^2].
struct MassProperties {
  double mass = 0;
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

/// Of several bodies as one. The centre of mass of bodies without mass is the middle of theirs.
MassProperties Joined(std::span<const MassProperties> bodies);

/// A body that moves, a link or all links that fixed joints hold together, and how it moves per unit of the independent
/// coordinates; ground axes, design pose.
struct BodyMotion {
  /// Of its heaviest link.
  std::string name;
  /// Indices in Vehicle::links.
  std::vector<int> links;
  MassProperties mass;
  /// 3 x n: velocity of the centre of mass, angular velocity.
  Eigen::MatrixXd com_jacobian;
  Eigen::MatrixXd spin_jacobian;
};

/// Bodies that have mass or inertia, in the order of their first links. `pose`: the design pose.
std::vector<BodyMotion> BodyMotions(const Vehicle& vehicle, const Kinematics& pose, std::span<const double> parameters);

/// Twice the kinetic energy of the body's motion at the rates J shape, by direction in ground axes: along x, y, z,
/// about x, y, z. What products of inertia add goes to both of their axes by halves.
Eigen::Matrix<double, 6, 1> EnergyByDirection(const BodyMotion& body, const Eigen::VectorXcd& shape);

}  // namespace fourpost
