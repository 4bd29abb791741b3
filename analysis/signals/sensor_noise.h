#pragma once

#include <optional>
#include <span>

namespace fourpost {

/// What a sensor reads at rest, about a straight line (thesis section 4.3).
struct SensorNoise {
  double sd = 0;
  /// See WhitenessOf().
  bool is_white = true;
  /// Skewness and excess kurtosis within four standard deviations of those of as many independent normal samples, or
  /// too small to matter: 0.3 and 0.5.
  bool is_normal = true;
  double skewness = 0;
  double kurtosis = 0;
  /// Below which 95 % of its power is; of white noise nearly half the rate.
  double below_Hz = 0;
  /// A line that stands twenty times above the median of the spectrum and holds a tenth of the power, such as mains
  /// hum.
  std::optional<double> line_Hz;
};

/// Throws std::invalid_argument for fewer than 64 samples.
SensorNoise SensorNoiseOf(std::span<const double> at_rest, double rate_Hz);

}  // namespace fourpost
