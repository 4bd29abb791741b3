#pragma once

#include <algorithm>
#include <limits>
#include <numbers>

namespace fourpost {

/// How far a rig moves its reference post at each frequency: a(f) = min(d, v / w, b / w^2), w = 2 pi f, so that neither
/// displacement d, velocity v nor acceleration b exceeds its limit. All are peak values; one at least is finite.
struct AmplitudeLaw {
  double displacement_m = std::numeric_limits<double>::infinity();
  double velocity_mps = std::numeric_limits<double>::infinity();
  double acceleration_mps2 = std::numeric_limits<double>::infinity();

  double At(double frequency_Hz) const {
    const double w = 2 * std::numbers::pi * frequency_Hz;
    return std::min({displacement_m, velocity_mps / w, acceleration_mps2 / (w * w)});
  }
};

}  // namespace fourpost
