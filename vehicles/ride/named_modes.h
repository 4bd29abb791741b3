#pragma once

#include <complex>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/kinematics.h"
#include "vehicles/ride/suspension.h"

namespace fourpost {

/// Modes with names and shares of energy at these parameter values, those of `model`. `pose`: the design pose.
std::vector<Mode> NamedModes(const Vehicle& vehicle, const Kinematics& pose, const Suspension& suspension,
                             const CondensedModel& model, std::span<const double> parameters);

/// The poles of a mode on and above the real axis [1/s]: two for an overdamped one, the slow one first.
std::vector<std::complex<double>> PolesOf(const Mode& mode);

/// How one body moves in a mode; ground axes.
struct BodyShape {
  std::string body;
  /// Of the centre of mass [m], along x, y, z.
  Eigen::Vector3cd translation;
  /// About x, y, z [rad].
  Eigen::Vector3cd rotation;
  /// Of the body [kg], and its radii of gyration about x, y, z [m].
  double mass = 0;
  Eigen::Vector3d gyration = Eigen::Vector3d::Zero();
};

/// The mode as motion of the bodies, scaled such that the largest component is 1: of translations in m, and of
/// rotations times the body's radius of gyration about that axis.
std::vector<BodyShape> BodyShapes(const std::vector<BodyMotion>& bodies, const Mode& mode);

}  // namespace fourpost
