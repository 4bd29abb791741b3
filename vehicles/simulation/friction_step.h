#pragma once

#include "vehicles/laws/dahl_friction.h"

namespace fourpost {

/// Time integration of friction that sticks, by steps over each of which its extension goes in one direction: exact
/// then, see DahlFriction.
class FrictionStep {
 public:
  explicit FrictionStep(const DahlFriction& law) : law_(law) {}

  /// Without force, at this extension. The first step leads from there in one stroke to where the motion begins.
  void Rest(double extension = 0);

  /// Tension [N] at the end of the step, at this extension [m].
  double Tension(double extension);

  /// Of the last evaluation: derivatives by the extension there (by that at the start minus this) and by the tension at
  /// the start.
  double ByExtension() const { return stroke_.by_extension; }
  double ByTension() const { return stroke_.by_force; }
  /// How much more tension another law gives from the same start [N].
  double Departure(const DahlFriction& other) const;

  /// Accepts the last evaluation as the end of the step, the start of the next.
  void Advance() { start_ = end_; }

 private:
  struct End {
    double tension = 0;
    double extension = 0;
  };

  DahlFriction law_;
  End start_;
  /// Of the last evaluation.
  End from_;
  End end_;
  DahlFriction::Stroke stroke_;
};

}  // namespace fourpost
