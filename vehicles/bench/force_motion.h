#pragma once

#include <optional>
#include <span>

namespace fourpost {

/// Share of the force's variance that is explained by the motion, by least squares of force on x, v, |v| and the
/// direction of v; every damper law contains some of these. 0 for a constant force. Spans of one length: extension x,
/// its rate v, force.
double ShareOfMotion(std::span<const double> x, std::span<const double> v, std::span<const double> force);

/// Resistance in bump and rebound, by least squares of force on
///   1, x, direction of v, v, |v|
/// The first two do no net work over a cycle: gas, an elastic force, an offset of the load cell. The last is the
/// difference of the two directions.
struct ForceSides {
  /// Work dissipated in bump over that in rebound; 1 if one of the two would be negative.
  double compression_over_rebound = 1;
  /// Share of |v| in the force's variance after removing the other terms: 0 if both directions are alike, close to 1 if
  /// only their difference remains.
  double share = 0;
};
ForceSides SidesOf(std::span<const double> x, std::span<const double> v, std::span<const double> force);

/// Phase of a force against the extension. A system that only stores and dissipates energy has first harmonics F/X = k
/// + i w c with k, c >= 0, between 0 and 90 degrees: a dashpot in series with a spring lags the velocity, never leads
/// it, and never lags as far as the extension.
struct MotionPhase {
  double frequency_Hz = 0;
  double phase_deg = 0;

  /// Lead of the force against the velocity [s]; negative: lag.
  double Lead_s() const { return (phase_deg - 90) / 360 / frequency_Hz; }
};

/// Over all samples, from k = sum F x / sum x^2 and c = sum F v / sum v^2, x and F without their means, w =
/// rms(v)/rms(x), v by central differences.
MotionPhase PhaseOf(std::span<const double> x, std::span<const double> force, double step_s);

/// The median of the fastest quarter of the cycles. Empty if none of them has eight samples.
std::optional<MotionPhase> PhaseOfFastest(std::span<const double> x, std::span<const double> force, double step_s);

}  // namespace fourpost
