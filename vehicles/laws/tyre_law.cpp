#include "vehicles/laws/tyre_law.h"

#include <algorithm>
#include <cmath>

namespace fourpost {

double TyreLaw::Force(double deflection) const {
  if (curve) return curve->Value(deflection);
  return stiffness * deflection * (1 + progression * std::max(0.0, deflection));
}

double TyreLaw::Slope(double deflection) const {
  if (curve) return curve->Slope(deflection);
  return stiffness * (1 + 2 * progression * std::max(0.0, deflection));
}

double TyreLaw::Energy(double deflection) const {
  if (curve) return curve->Integral(deflection);
  const double square = deflection * deflection;
  return stiffness * square * (0.5 + progression * std::max(0.0, deflection) / 3);
}

double TyreLaw::Deflection(double load) const {
  if (curve) return curve->Argument(load);
  const double rate = std::sqrt(stiffness * (stiffness + 4 * progression * std::max(0.0, load)));
  return 2 * load / (stiffness + rate);
}

LoadedTyre TyreLaw::Under(double load) const {
  return {.law = *this, .load = load, .place = IsLinear() ? 0 : Deflection(load)};
}

double LoadedTyre::Force(double e) const { return load + (law.Force(place + e) - law.Force(place)); }

double LoadedTyre::Energy(double e) const {
  return (load - law.Force(place)) * e + (law.Energy(place + e) - law.Energy(place));
}

double LoadedTyre::Liftoff() const { return law.IsLinear() ? -load / law.stiffness : law.Deflection(0) - place; }

}  // namespace fourpost
