#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/description/vehicle.h"
#include "vehicles/loops/link_motion.h"
#include "vehicles/multibody/kinematics.h"

namespace fourpost {

/// Motions of all links except the ground, at the file's parameter values, in the coordinates of the pose.
std::vector<LinkMotion> LinkMotionsOf(const Vehicle& vehicle, const Kinematics& pose);

/// A small motion of a vehicle, named by the link and the direction that carry most of its kinetic energy.
struct NamedMotion {
  enum class Direction { kForeAft, kLateral, kHeave, kRoll, kPitch, kYaw };
  std::string link;
  Direction direction = Direction::kHeave;
  /// In the coordinates of the links' Jacobians.
  Eigen::VectorXd shape;

  /// "roll of link 'front_axle'".
  std::string Text() const;
};

/// Six rows per link, for its translation and rotation in the links' order: the squares of their products with a motion
/// are twice the kinetic energies.
Eigen::MatrixXd EnergyRows(const std::vector<LinkMotion>& links, Eigen::Index coordinates);

/// "heave", "fore-aft motion" ...
std::string Word(NamedMotion::Direction direction);

/// Motions that together span the columns of `basis`, separated as far as possible: each contains all of the basis in
/// one direction of one link, the most energetic first; the following ones are free of that direction. Motions that
/// move no mass have no name and are left out.
std::vector<NamedMotion> NameMotions(const std::vector<LinkMotion>& links, Eigen::MatrixXd basis);

}  // namespace fourpost
