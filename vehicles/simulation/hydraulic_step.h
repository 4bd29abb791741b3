#pragma once

#include <array>

#include "vehicles/condensed/port.h"

namespace fourpost {

/// The port of a hydraulic damper from one step of length h to the next. The oil in its rebound chamber, of density at
/// rest, is V = surplus - A_a e more than at rest; by the second-order backward difference, which damps what is faster
/// than the steps,
///   (3 V_k - 4 V_{k-1} + V_{k-2}) / (2 h) = -Q(V_k, e_k)
/// see HydraulicOil. The remainder is the tension less that of the linear share, stiffness e + series x, where x is the
/// extension of the share's series spring.
class HydraulicStep {
 public:
  HydraulicStep(const HydraulicRemainder& port, double step_s);

  /// As at rest ever since.
  void Rest();

  /// At the end of the step, if it comes to these [N]. NaN where a chamber closes.
  double Remainder(double extension, double lag);

  /// What was evaluated last, of the rebound and the compression chamber [Pa].
  std::array<double, 2> PressuresAboveRest() const;

  /// Derivatives there.
  double ByExtension() const { return by_extension_; }
  double ByLag() const { return -share_.series; }

  /// Takes what was evaluated last as the end of the step, the start of the next.
  void Advance();

  /// The largest tension that rounding is relative to [N]: that of the gas on the piston.
  double Size() const;

 private:
  HydraulicOil oil_;
  HydraulicOil::LinearShare share_;
  double step_s_;
  HydraulicOil::State now_;
  double extension_ = 0;
  double by_extension_ = 0;
  /// V after the last two steps, the earlier one first.
  double earlier_ = 0;
  double last_ = 0;
};

}  // namespace fourpost
