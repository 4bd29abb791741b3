#pragma once

#include <array>

#include "vehicles/condensed/port.h"

namespace fourpost {

/// Time integration of a hydraulic damper's port by steps of length h. The oil in its rebound chamber, at its density
/// at rest, is V = surplus - A_a e more than at rest; by the second-order backward difference, which damps all motion
/// too fast for the steps,
///   (3 V_k - 4 V_{k-1} + V_{k-2}) / (2 h) = -Q(V_k, e_k)
/// see HydraulicOil. The nonlinear part is the tension minus that of the linear part, stiffness e + series x, where x
/// is the extension of the linear part's series spring.
class HydraulicStep {
 public:
  HydraulicStep(const HydraulicRemainder& port, double step_s);

  /// As if always at rest.
  void Rest();

  /// Nonlinear part [N] at the end of the step, at this extension and this x (`lag`) [m]. NaN if a chamber closes.
  double Remainder(double extension, double lag);

  /// Result of the last evaluation, for the rebound and the bump chamber [Pa].
  std::array<double, 2> PressuresAboveRest() const;

  /// Derivatives there.
  double ByExtension() const { return by_extension_; }
  double ByLag() const { return -share_.series; }

  /// Accepts the last evaluation as the end of the step, the start of the next.
  void Advance();

  /// The largest tension that determines rounding [N]: that of the gas on the piston.
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
