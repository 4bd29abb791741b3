#pragma once

#include <optional>

#include "vehicles/laws/monotone_curve.h"

namespace fourpost {

struct LoadedTyre;

/// Vertical force of a tyre [N], pushing positive, over its deflection d [m], without damping:
///   F = stiffness d (1 + progression d),  F = stiffness d for d < 0
/// (H. B. Pacejka, Tire and Vehicle Dynamics, 3rd ed. 2012, the normal load of chapter 4 without speed, side force and
/// pressure), or a measured curve, whose deflections have a zero of their own. On the ground F > 0: where it is not, a
/// tyre that lifts off has no force. The rate under a load F is sqrt(stiffness^2 + 4 stiffness progression F).
struct TyreLaw {
  double stiffness = 0;                     // N/m, of an unloaded tyre
  double progression = 0;                   // 1/m, not negative
  std::optional<MonotoneCurve> curve = {};  // N over m, strictly increasing; instead of both

  double Force(double deflection) const;
  /// dF/dd [N/m].
  double Slope(double deflection) const;
  /// Integral of Force from 0 [J].
  double Energy(double deflection) const;
  /// The deflection under a load [m]; needs a rate.
  double Deflection(double load) const;

  bool IsLinear() const { return progression == 0 && !curve; }

  /// At rest under a load [N].
  LoadedTyre Under(double load) const;

  bool operator==(const TyreLaw&) const = default;
};

/// A tyre that carries a load at rest; e [m]: its deflection from there.
struct LoadedTyre {
  TyreLaw law;
  double load = 0;   // N
  double place = 0;  // m, deflection at rest; 0 of a linear law, whose force needs none

  /// load + F(place + e) - F(place).
  double Force(double e) const;
  /// dForce/de [N/m].
  double Rate(double e) const { return law.Slope(place + e); }
  /// Integral of Force from 0 to e [J].
  double Energy(double e) const;
  /// Where Force is zero [m]; needs a rate.
  double Liftoff() const;

  bool operator==(const LoadedTyre&) const = default;
};

}  // namespace fourpost
