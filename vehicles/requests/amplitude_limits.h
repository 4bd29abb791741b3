#pragma once

#include <span>
#include <string>

#include "analysis/text/diagnostics.h"
#include "vehicles/response/amplitude_law.h"

namespace fourpost {

/// Limits of the reference post, peak, as a user writes them; empty: none.
struct LimitText {
  std::string amplitude;
  std::string velocity;
  std::string acceleration;
};

/// Limits of the shipped recordings: posts with valves for 0.15 m/s, and a car that stays on them.
inline constexpr AmplitudeLaw kUsualAmplitude{.displacement_m = 0.012, .velocity_mps = 0.15, .acceleration_mps2 = 6};

/// Stroke of a four-post rig's actuators, from end to end.
inline constexpr double kUsualStroke_m = 0.15;

/// Stroke of posts without one in the vehicle file; kUsualStroke_m for an empty text. Adds an error about "--stroke"
/// for an invalid text.
double ReadStroke(const std::string& text, Diagnostics& diagnostics);

/// kUsualAmplitude if all three are empty; otherwise only the given limits apply. Adds an error, about "--amplitude",
/// "--velocity" or "--acceleration", for each invalid text.
AmplitudeLaw ReadLimits(const LimitText& text, Diagnostics& diagnostics);

/// "12 mm, 0.15 m/s, 6 m/s^2": the limits that are finite.
std::string LimitsText(const AmplitudeLaw& law);

/// Adds a warning if limits that were not given let the post move beyond the usual ones at one of these frequencies.
void WarnBeyondUsual(const AmplitudeLaw& law, std::span<const double> frequency_Hz, Diagnostics& diagnostics);

}  // namespace fourpost
