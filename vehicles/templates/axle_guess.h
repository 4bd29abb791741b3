#pragma once

#include <array>

#include "vehicles/templates/axle_knowledge.h"

namespace fourpost {

/// What a drawing of points does not say of one axle; SI.
struct AxleGuess {
  /// One coil, or leaf, [N/m]; one damper's mean rate [N s/m].
  double spring_rate = 25e3;
  double damper_rate = 1500;
  /// Shortening of the damper per rise of both wheels.
  double damper_ratio = 1;
  /// The same of the spring, which the source of its rate states.
  double spring_ratio = 1;
  /// What is known stands.
  KnownAxle known;
};

/// Front and rear.
using CarGuess = std::array<AxleGuess, 2>;

}  // namespace fourpost
