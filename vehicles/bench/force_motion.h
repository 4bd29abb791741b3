#pragma once

#include <optional>
#include <span>

namespace fourpost {

/// Share of the force's variance that goes with the motion: by least squares of force on x, v, |v| and the direction of
/// v, of which every law of a damper has some. 0 for a constant force. Spans of one length: extension x, its rate v,
/// force.
double ShareOfMotion(std::span<const double> x, std::span<const double> v, std::span<const double> force);

/// How a force resists compression and rebound, by least squares of force on
///   1, x, direction of v, v, |v|
/// The first two do no net work over a cycle: gas, an elastic force, an offset of the load cell. The last is the
/// difference of the sides.
struct ForceSides {
  /// Work of what is dissipated in compression over that in rebound; 1 where one of the two would be negative.
  double compression_over_rebound = 1;
  /// Share of what the other terms leave of the force's variance that goes with |v|: 0 where the sides are alike, next
  /// to 1 where nothing but their difference is left.
  double share = 0;
};
ForceSides SidesOf(std::span<const double> x, std::span<const double> v, std::span<const double> force);

/// Phase of a force against the extension. What only stores and dissipates has first harmonics
/// F/X = k + i w c with k, c >= 0, between 0 and 90 degrees: a dashpot in line with a spring falls behind the speed,
/// never before it, and never as far as the extension.
struct MotionPhase {
  double frequency_Hz = 0;
  double phase_deg = 0;

  /// By how much the force comes before the speed [s]; negative: after it.
  double Lead_s() const { return (phase_deg - 90) / 360 / frequency_Hz; }
};

/// Over all samples, from k = sum F x / sum x^2 and c = sum F v / sum v^2, x and F without their means,
/// w = rms(v)/rms(x), v by central differences.
MotionPhase PhaseOf(std::span<const double> x, std::span<const double> force, double step_s);

/// The median of the fastest quarter of the cycles. Nothing without eight samples in one of them.
std::optional<MotionPhase> PhaseOfFastest(std::span<const double> x, std::span<const double> force, double step_s);

}  // namespace fourpost
