#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "analysis/signals/uniform_spline.h"

namespace fourpost {

// Motions of a reference post over time, from t = 0 to their duration; it rests before and after. All are splines
// through samples, so that height, velocity and acceleration are consistent.

/// A sine whose frequency sweeps from one value to another, faded in and out.
struct SweptSine {
  double first_Hz = 0;
  /// Final frequency; equal to the first: a plain sine.
  double last_Hz = 0;
  double duration_s = 0;
  double amplitude_m = 0;
  /// Amplitude falls as 1/f where its peak velocity would be higher [m/s].
  double top_speed = std::numeric_limits<double>::infinity();
  /// And as 1/f^2 where its peak acceleration would be higher [m/s^2].
  double top_acceleration = std::numeric_limits<double>::infinity();
  /// Rate of the sweep in octaves, or else in hertz, per second.
  bool logarithmic = true;

  double AmplitudeAt(double frequency_Hz) const;

  /// Throws std::invalid_argument naming the field that is not positive and finite.
  UniformSpline Signal() const;
};

/// Sines of one frequency after the other, each faded in and out over a cycle of its own, from rest to rest.
struct SteppedSine {
  struct Dwell {
    double frequency_Hz = 0;
    double amplitude_m = 0;
    double duration_s = 0;
  };
  std::vector<Dwell> dwells;

  double Duration() const;
  /// Throws std::invalid_argument without a dwell, or for one that is not positive or shorter than two cycles.
  UniformSpline Signal() const;
};

/// From one height to another: 0 until `start_s`, then height (6 u^5 - 15 u^4 + 10 u^3) over u = 0 to 1, the share of
/// the rise time. Peak velocity 1.875 height / rise.
struct SmoothStep {
  double height_m = 0;
  double rise_s = 0;
  double start_s = 0;

  /// Throws std::invalid_argument for a height that is not finite or times that are not positive.
  UniformSpline Signal() const;
};

/// Random heights with one-sided spectral density ~ 1/f^2 in a band, i.e. white velocity, as of roads: sines of given
/// size with random phases (Shinozuka and Deodatis, Applied Mechanics Reviews 44, 1991), faded in and out within a
/// second.
struct RandomHeights {
  double rms_m = 0;
  double lower_Hz = 0;
  double upper_Hz = 0;
  double duration_s = 0;
  std::uint64_t seed = 0;

  /// Throws std::invalid_argument naming the field that is out of bounds.
  UniformSpline Signal() const;
};

}  // namespace fourpost
