#pragma once

namespace fourpost {

/// A rate that is a parabola of time: the rate of a cubic spline of positions between two samples.
struct RatePiece {
  double duration_s = 0;
  /// At the start [m/s], [m/s^2], [m/s^3].
  double rate = 0;
  double acceleration = 0;
  double jerk = 0;

  double RateAt(double t) const { return rate + (acceleration + 0.5 * jerk * t) * t; }
  double AccelerationAt(double t) const { return acceleration + jerk * t; }

  /// The remaining piece after time t.
  RatePiece From(double t) const { return {duration_s - t, RateAt(t), AccelerationAt(t), jerk}; }
};

}  // namespace fourpost
