#pragma once

#include <span>
#include <string>

#include "analysis/diagnostics.h"
#include "vehicles/response/amplitude_law.h"

namespace fourpost {

/// Limits of the reference post, peak, as a user writes them; empty: none.
struct LimitText {
  std::string amplitude;
  std::string velocity;
  std::string acceleration;
};

/// That of the shipped recordings: what posts with 0.15 m/s of valve and a car that stays on them allow.
inline constexpr AmplitudeLaw kUsualAmplitude{.displacement_m = 0.012, .velocity_mps = 0.15, .acceleration_mps2 = 6};

/// Of a four-post rig's actuators, from end to end.
inline constexpr double kUsualStroke_m = 0.15;

/// Of posts whose stroke the vehicle file does not tell; kUsualStroke_m where nothing is written. Adds an error about
/// "--stroke" for what cannot be read.
double ReadStroke(const std::string& text, Diagnostics& diagnostics);

/// kUsualAmplitude where all three are empty; where one is not, only what is written. Adds an error, about
/// "--amplitude", "--velocity" or "--acceleration", for each that cannot be read.
AmplitudeLaw ReadLimits(const LimitText& text, Diagnostics& diagnostics);

/// "12 mm, 0.15 m/s, 6 m/s^2": the limits that are finite.
std::string LimitsText(const AmplitudeLaw& law);

/// Adds a warning where limits that were not written let the post move, at one of these frequencies, beyond the usual
/// ones.
void WarnBeyondUsual(const AmplitudeLaw& law, std::span<const double> frequency_Hz, Diagnostics& diagnostics);

}  // namespace fourpost
