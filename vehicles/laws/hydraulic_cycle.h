#pragma once

#include <optional>
#include <span>
#include <vector>

#include "vehicles/laws/hydraulic_oil.h"

namespace fourpost {

/// Periodic solution of HydraulicOil for an extension that repeats every `period` [s], at samples in equal steps h, by
/// the second-order backward difference, which damps all motion too fast for the steps:
///   (3 s_k - 4 s_{k-1} + s_{k-2}) / (2 h) = A_a x'_k - Q(s_k, x_k),   s: surplus
class HydraulicCycle {
 public:
  /// At least three samples of the extension [m] from mid-stroke, of damper and mount together, and of its rate [m/s].
  /// Empty if a chamber closes or a value is not finite.
  static std::optional<HydraulicCycle> Solve(const MountedHydraulicDamper& damper, double period,
                                             std::span<const double> extension, std::span<const double> rate);

  /// At the samples.
  const std::vector<HydraulicOil::State>& states() const { return states_; }

  /// First-order change of the tension [N] for small changes of extension and rate, with equal numbers of samples.
  void Change(std::span<const double> extension, std::span<const double> rate, std::span<double> tension) const;

 private:
  explicit HydraulicCycle(const MountedHydraulicDamper& damper) : oil_(damper) {}

  HydraulicOil oil_;
  double step_ = 0;
  std::vector<HydraulicOil::State> states_;
  std::vector<HydraulicOil::Slopes> slopes_;
};

}  // namespace fourpost
