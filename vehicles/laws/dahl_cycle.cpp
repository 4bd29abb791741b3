#include "vehicles/laws/dahl_cycle.h"

#include <cmath>
#include <cstddef>

namespace fourpost {

DahlCycle::DahlCycle(const DahlFriction& law, std::span<const double> extension)
    : forces_(extension.size()), by_extension_(extension.size()), by_force_(extension.size()) {
  double path = 0;
  double before = extension.back();
  for (const double now : extension) {
    path += std::abs(now - before);
    before = now;
  }
  if (law.force == 0 || path == 0) return;
  forgotten_ = -std::expm1(-law.stiffness * path / law.force);
  const auto run = [&](double force) {
    double from = extension.back();
    for (std::size_t k = 0; k < extension.size(); ++k) {
      const DahlFriction::Stroke stroke = law.After(force, extension[k] - from);
      forces_[k] = force = stroke.force;
      by_extension_[k] = stroke.by_extension;
      by_force_[k] = stroke.by_force;
      from = extension[k];
    }
    return force;
  };
  run(run(0) / forgotten_);
}

void DahlCycle::Change(std::span<const double> extension, std::span<double> force) const {
  const auto run = [&](double change) {
    double from = extension.back();
    for (std::size_t k = 0; k < extension.size(); ++k) {
      force[k] = change = by_force_[k] * change + by_extension_[k] * (extension[k] - from);
      from = extension[k];
    }
    return change;
  };
  const double once = run(0);
  if (forgotten_ > 0) run(once / forgotten_);
}

}  // namespace fourpost
