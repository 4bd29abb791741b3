#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "vehicles/templates/axle_knowledge.h"
#include "vehicles/templates/axle_points.h"

namespace fourpost {

/// The drawing against the level ground: R_y(pitch) p + (0, 0, rise).
struct GroundPose {
  double pitch = 0;
  double rise = 0;

  double HeightOf(const Eigen::Vector3d& place) const {
    return -std::sin(pitch) * place.x() + std::cos(pitch) * place.z() + rise;
  }
};

/// Of a passenger car with two people [kg].
inline constexpr double kBodyMass = 1200;

/// Mass of the body and x of its centre in the drawing.
struct BodyGuess {
  double mass = kBodyMass;
  double x = 0;
  bool is_weighed = false;
  std::optional<KnownBody> known = {};
};

/// At so many decimals, without zeros at the end.
std::string Fixed(double value, int decimals);

/// The body's link with its joint, and the parameters of its mass, centre and inertia. `origin`: of a model's numbers.
std::string BodyText(const CarPoints& car, const BodyGuess& body, const GroundPose& ground, const std::string& origin);

}  // namespace fourpost
