#pragma once

namespace fourpost {

/// Bilinear dashpot: f(v) = rebound v for v > 0, compression v for v <= 0.
/// v: extension rate [m/s], rebound positive. f: force [N], tension positive. Rates [N s/m], >= 0.
/// Source: thesis table 3.3.1, model 2; equal rates give model 1.
struct BilinearDashpot {
  double compression = 0;
  double rebound = 0;

  double Force(double v) const { return (v > 0 ? rebound : compression) * v; }

  /// The rate that carries this force; both rates must be positive.
  double Velocity(double force) const { return force / (force > 0 ? rebound : compression); }

  /// f(v) = Mean() v + HalfDifference() |v|. The mean is also the exact first-harmonic rate for a sinusoidal v.
  double Mean() const { return 0.5 * (rebound + compression); }
  double HalfDifference() const { return 0.5 * (rebound - compression); }
};

/// Bilinear dashpot in line with a linear spring: force f = stiffness x = d(v - dx/dt), x the spring's extension [m].
/// Source: thesis table 3.3.1, model 3. Stiffness [N/m], > 0; both rates must be positive.
struct SeriesDamper {
  BilinearDashpot dashpot;
  double stiffness = 0;

  double Force(double x) const { return stiffness * x; }

  /// dx/dt for the damper's extension rate v.
  double SpringRate(double v, double x) const { return v - dashpot.Velocity(Force(x)); }
};

}  // namespace fourpost
