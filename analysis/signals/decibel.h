#pragma once

#include <cmath>
#include <numbers>

namespace fourpost {

/// Ratio of two amplitudes from its level: 20 dB are a factor of 10.
inline double GainFromDecibel(double level_dB) { return std::pow(10.0, level_dB / 20); }

/// Level of a ratio of two amplitudes, 20 log10(gain); minus infinity for 0 and NaN below.
inline double DecibelFromGain(double gain) { return 20 * std::log10(gain); }

inline double DegreesFromRadians(double angle_rad) { return angle_rad * (180 / std::numbers::pi); }
inline double RadiansFromDegrees(double angle_deg) { return angle_deg * (std::numbers::pi / 180); }

}  // namespace fourpost
