#include "vehicles/requests/amplitude_limits.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "analysis/text/units.h"
#include "vehicles/requests/findings.h"
#include "vehicles/requests/option_quantity.h"

namespace fourpost {
namespace {

double ReadLimit(const std::string& text, const Dimension& dimension, const char* option, Diagnostics& diagnostics) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (text.empty()) return kNone;
  return ReadQuantity(text, dimension, option, diagnostics).value_or(kNone);
}

std::string Shown(double value, const char* unit) {
  char text[48];
  std::snprintf(text, sizeof text, "%.3g %s", value, unit);
  return text;
}

/// The most a post moves within a law at these frequencies.
AmplitudeLaw MostWithin(const AmplitudeLaw& law, std::span<const double> frequency_Hz) {
  AmplitudeLaw most{.displacement_m = 0, .velocity_mps = 0, .acceleration_mps2 = 0};
  for (const double frequency : frequency_Hz) {
    const double w = 2 * std::numbers::pi * frequency;
    const double amplitude = law.At(frequency);
    most.displacement_m = std::max(most.displacement_m, amplitude);
    most.velocity_mps = std::max(most.velocity_mps, w * amplitude);
    most.acceleration_mps2 = std::max(most.acceleration_mps2, w * w * amplitude);
  }
  return most;
}

}  // namespace

double ReadStroke(const std::string& text, Diagnostics& diagnostics) {
  if (text.empty()) return kUsualStroke_m;
  return ReadQuantity(text, kLength, "--stroke", diagnostics).value_or(kUsualStroke_m);
}

AmplitudeLaw ReadLimits(const LimitText& text, Diagnostics& diagnostics) {
  if (text.amplitude.empty() && text.velocity.empty() && text.acceleration.empty()) return kUsualAmplitude;
  return {.displacement_m = ReadLimit(text.amplitude, kLength, "--amplitude", diagnostics),
          .velocity_mps = ReadLimit(text.velocity, kVelocity, "--velocity", diagnostics),
          .acceleration_mps2 = ReadLimit(text.acceleration, kAcceleration, "--acceleration", diagnostics)};
}

std::string LimitsText(const AmplitudeLaw& law) {
  std::string text;
  const auto add = [&](double value, const char* unit) {
    if (std::isfinite(value)) text += (text.empty() ? "" : ", ") + Shown(value, unit);
  };
  add(law.displacement_m * 1e3, "mm");
  add(law.velocity_mps, "m/s");
  add(law.acceleration_mps2, "m/s^2");
  return text;
}

void WarnBeyondUsual(const AmplitudeLaw& law, std::span<const double> frequency_Hz, Diagnostics& diagnostics) {
  // Rounding of w^2 b / w^2.
  constexpr double kSlack = 1 + 1e-9;
  const AmplitudeLaw most = MostWithin(law, frequency_Hz);
  const auto warn = [&](const char* option, double limit, double reached, double usual, double scale,
                        const char* unit) {
    if (std::isfinite(limit) || reached <= kSlack * usual) return;
    diagnostics.Report(kLimitOpen, Place::Option(option), {Shown(scale * usual, unit), Shown(scale * reached, unit)});
  };
  warn("--amplitude", law.displacement_m, most.displacement_m, kUsualAmplitude.displacement_m, 1e3, "mm");
  warn("--velocity", law.velocity_mps, most.velocity_mps, kUsualAmplitude.velocity_mps, 1, "m/s");
  warn("--acceleration", law.acceleration_mps2, most.acceleration_mps2, kUsualAmplitude.acceleration_mps2, 1, "m/s^2");
}

}  // namespace fourpost
