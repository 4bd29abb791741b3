#pragma once

#include <optional>
#include <vector>

#include "vehicles/laws/monotone_curve.h"

namespace fourpost {

/// Tension of a spring [N] over its extension x from the design pose [m], without preload: f(0) = 0.
///   f = stiffness x + cubic x^3 + sum over knees of g(x) - g(0) + c(x) - c(0)
/// g, the term of a knee, acts on one side of a point: stiffness e + cubic e^3, e = x - at, for side e > 0. Its force
/// in the design pose belongs to the preload, and so does that of c, a measured curve.
struct SpringLaw {
  /// Change of rate of a multirate spring (a negative one softens), or a stop.
  struct Knee {
    double at = 0;         // m
    int side = 1;          // +1: acts for x > at, -1: for x < at
    double stiffness = 0;  // N/m
    double cubic = 0;      // N/m^3

    bool operator==(const Knee&) const = default;
  };

  double stiffness = 0;  // N/m
  double cubic = 0;      // N/m^3
  std::vector<Knee> knees = {};
  std::optional<MonotoneCurve> curve = {};  // N over m

  double Force(double x) const;
  /// df/dx [N/m]; at a kink the mean of both sides.
  double Slope(double x) const;
  /// Integral of Force from 0 to x [J].
  double Energy(double x) const;

  /// Whether the law has no cubic term, no effective knee and no curve.
  bool IsLinear() const;

  /// All numbers finite, sides +1 or -1; else throws std::invalid_argument naming the field and its value.
  void Validate() const;

  bool operator==(const SpringLaw&) const = default;
};

}  // namespace fourpost
