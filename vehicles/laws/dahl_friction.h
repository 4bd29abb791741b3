#pragma once

#include <complex>

namespace fourpost {

/// Dry friction that gives way elastically before it slides (P. Dahl, A Solid Friction Model, Aerospace Corporation
/// TOR-0158(3107-18)-1, 1968, with exponent 1): tension F [N] over the extension x [m] of what rubs,
///   F' = stiffness (x' - |x'| F / force)
/// F starts from rest like a spring of rate `stiffness` and tends to `force` as it slides, with neither speed nor
/// smoothing in it: F is a function of the path alone. Along a stroke in one direction s = sign(x')
///   F(x) = s force + (F(x_0) - s force) exp(-stiffness |x - x_0| / force)
/// so that any motion that turns round only between steps is stepped exactly. Never stiffer than a spring of twice the
/// rate. A cycle between -A and A dissipates
///   4 force (A - force / stiffness tanh(stiffness A / force))
struct DahlFriction {
  double force = 0;      // N, while sliding
  double stiffness = 0;  // N/m, before

  struct Stroke {
    double force = 0;  // N, at its end
    /// Derivatives of that by the extension there, of that by the force at the start; by the extension at the start it
    /// is minus the first. Of a stroke of length zero the mean of both directions.
    double by_extension = 0;
    double by_force = 0;
  };
  /// From the force at its start, over this extension in one direction [m].
  Stroke After(double force_at_start, double extension) const;

  /// F' [N/s] at extension rate v [m/s].
  double Rate(double v, double at_force) const;

  /// First harmonic of the tension over that of a sinusoidal extension of this amplitude A [N/m]; with a = stiffness A
  /// / force
  ///   force / A [2 I_1(a) / cosh a + 4 i / pi (1 - tanh(a) / a)],   I_1: modified Bessel function
  /// whose imaginary part is the loss of a cycle over pi A^2. The stiffness for no amplitude.
  std::complex<double> Gain(double amplitude) const;

  /// Positive stiffness, force not negative, both finite; else throws std::invalid_argument naming field, value and
  /// bound.
  void Validate() const;

  bool operator==(const DahlFriction&) const = default;
};

}  // namespace fourpost
