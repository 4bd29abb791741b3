#include "vehicles/laws/dahl_friction.h"

#include <cmath>

#include "analysis/text/option_check.h"

namespace fourpost {

DahlFriction::Stroke DahlFriction::After(double force_at_start, double extension) const {
  if (force == 0) return {};
  if (extension == 0) return {force_at_start, stiffness, 1};
  const double sliding = std::copysign(force, extension);
  const double kept = std::exp(-stiffness * std::abs(extension) / force);
  const double end = sliding + (force_at_start - sliding) * kept;
  return {end, stiffness * (1 - end / sliding), kept};
}

double DahlFriction::Rate(double v, double at_force) const {
  return force == 0 ? 0 : stiffness * (v - std::abs(v) * at_force / force);
}

void DahlFriction::Validate() const {
  RequireOption(force >= 0 && std::isfinite(force), "DahlFriction: force", force, "finite and not negative");
  RequireOption(stiffness > 0 && std::isfinite(stiffness), "DahlFriction: stiffness", stiffness, "finite and positive");
}

}  // namespace fourpost
