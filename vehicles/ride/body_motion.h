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

/// Of several bodies as one. If they have no mass, the centre of mass is the mean of theirs.
MassProperties Joined(std::span<const MassProperties> bodies);

/// A moving body, a link or all links that fixed joints hold together, and its motion per unit of the independent
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
/// about x, y, z. Half of each product-of-inertia term goes to each of its two axes.
Eigen::Matrix<double, 6, 1> EnergyByDirection(const BodyMotion& body, const Eigen::VectorXcd& shape);

}  // namespace fourpost
