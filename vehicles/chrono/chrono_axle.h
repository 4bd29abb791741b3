#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "vehicles/chrono/chrono_node.h"
#include "vehicles/templates/axle_knowledge.h"
#include "vehicles/templates/hard_points.h"
#include "vehicles/templates/suspension_kind.h"

namespace fourpost {

/// An axle of a vehicle of Chrono, in the frame of its chassis.
struct ChronoAxle {
  /// nullptr after a fault.
  const SuspensionKind* kind = nullptr;
  /// Without `contact`, which a tyre decides.
  std::vector<HardPoint> points;
  KnownAxle known;
  /// Both wheels with all that moves with them.
  KnownBody unsprung;
  /// What counts with the chassis: halves of rods that end there.
  KnownBody on_body;
};

/// How parts of an axle have moved in the frame of the chassis, left side, by their short names; others have not.
using ChronoMotion = std::map<std::string, Eigen::Isometry3d, std::less<>>;

/// Wheel and tyre of one side: mass and moments of inertia about the wheel's centre; `radius` without load.
struct ChronoTyre {
  double mass = 0;
  Eigen::Vector3d inertia = Eigen::Vector3d::Zero();
  double radius = 0;
  std::optional<double> rate;
  std::optional<double> damping;
};

/// The templates that are read, for messages: "DoubleWishbone, MacPhersonStrut, ...".
std::string ChronoTemplates();

/// `entry`: of "Axles"; `axle`: "front" or "rear". Places, bodies and lengths are those after the motion.
ChronoAxle ReadChronoAxle(const ChronoNode& entry, const std::string& axle, const ChronoTyre& tyre,
                          const ChronoMotion& motion);

}  // namespace fourpost
