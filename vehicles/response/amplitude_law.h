#pragma once

#include <algorithm>
#include <limits>
#include <numbers>

namespace fourpost {

/// Amplitude of the reference post at each frequency: a(f) = min(d, v / w, b / w^2), w = 2 pi f, so that displacement
/// d, velocity v and acceleration b stay within their limits. All are peak values; at least one is finite.
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
