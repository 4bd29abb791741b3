#pragma once

#include <span>
#include <vector>

#include "vehicles/laws/dahl_friction.h"

namespace fourpost {

/// Periodic solution of DahlFriction for an extension that repeats, at its samples; strokes between samples go in one
/// direction. The force after a period is a straight line over that before it, of slope exp(-stiffness path / force),
/// so that one pass finds the force that repeats.
class DahlCycle {
 public:
  /// At least one sample of the extension [m]. Without motion the force is zero.
  DahlCycle(const DahlFriction& law, std::span<const double> extension);

  /// At the samples [N].
  const std::vector<double>& forces() const { return forces_; }

  /// First-order change of the forces [N] for a small change of the extension, equal numbers of samples.
  void Change(std::span<const double> extension, std::span<double> force) const;

 private:
  std::vector<double> forces_;
  /// Of the stroke that ends at each sample, see DahlFriction::Stroke.
  std::vector<double> by_extension_;
  std::vector<double> by_force_;
  /// Of the force after a period by that before it: one less the slope.
  double forgotten_ = 0;
};

}  // namespace fourpost
