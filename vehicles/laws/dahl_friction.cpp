#include "vehicles/laws/dahl_friction.h"

#include <cmath>
#include <numbers>

#include "analysis/numerics/bessel.h"
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

std::complex<double> DahlFriction::Gain(double amplitude) const {
  using std::numbers::pi;
  if (force == 0) return 0;
  const double a = stiffness * amplitude / force;
  // Of the Taylor series what counts, where the closed form cancels.
  constexpr double kFew = 1e-3;
  if (a < kFew) return {stiffness * (1 - 3 * a * a / 8), stiffness * 4 * a / (3 * pi)};
  // exp(-a) / cosh(a) would be 0 / infinity for a large a.
  const double in_phase = 2 * ScaledBesselI1(a) * (1 + std::tanh(a));
  return force / amplitude * std::complex<double>(in_phase, 4 / pi * (1 - std::tanh(a) / a));
}

void DahlFriction::Validate() const {
  RequireOption(force >= 0 && std::isfinite(force), "DahlFriction: force", force, "finite and not negative");
  RequireOption(stiffness > 0 && std::isfinite(stiffness), "DahlFriction: stiffness", stiffness, "finite and positive");
}

}  // namespace fourpost
