#include "vehicles/laws/spring_law.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

using Knee = SpringLaw::Knee;

double Beyond(const Knee& knee, double x) {
  const double e = x - knee.at;
  return knee.side * e > 0 ? e : 0;
}

double KneeForce(const Knee& knee, double x) {
  const double e = Beyond(knee, x);
  return (knee.stiffness + knee.cubic * e * e) * e;
}

double KneeSlope(const Knee& knee, double x) {
  if (x == knee.at) return 0.5 * knee.stiffness;
  const double e = Beyond(knee, x);
  return e == 0 ? 0 : knee.stiffness + 3 * knee.cubic * e * e;
}

double KneeEnergy(const Knee& knee, double x) {
  const double e = Beyond(knee, x);
  return (0.5 * knee.stiffness + 0.25 * knee.cubic * e * e) * e * e;
}

void RequireFinite(const std::string& field, double value) {
  RequireOption(std::isfinite(value), "SpringLaw: " + field, value, "finite");
}

}  // namespace

double SpringLaw::Force(double x) const {
  double force = (stiffness + cubic * x * x) * x;
  for (const Knee& knee : knees) force += KneeForce(knee, x) - KneeForce(knee, 0);
  if (curve) force += curve->Value(x) - curve->Value(0);
  return force;
}

double SpringLaw::Slope(double x) const {
  double slope = stiffness + 3 * cubic * x * x;
  for (const Knee& knee : knees) slope += KneeSlope(knee, x);
  if (curve) slope += curve->Slope(x);
  return slope;
}

double SpringLaw::Energy(double x) const {
  double energy = (0.5 * stiffness + 0.25 * cubic * x * x) * x * x;
  for (const Knee& knee : knees) energy += KneeEnergy(knee, x) - KneeEnergy(knee, 0) - KneeForce(knee, 0) * x;
  if (curve) energy += curve->Integral(x) - curve->Value(0) * x;
  return energy;
}

bool SpringLaw::IsLinear() const {
  const auto adds_nothing = [](const Knee& knee) { return knee.stiffness == 0 && knee.cubic == 0; };
  return cubic == 0 && !curve && std::all_of(knees.begin(), knees.end(), adds_nothing);
}

void SpringLaw::Validate() const {
  RequireFinite("stiffness", stiffness);
  RequireFinite("cubic", cubic);
  for (std::size_t i = 0; i < knees.size(); ++i) {
    const std::string field = "knees[" + std::to_string(i) + "].";
    RequireFinite(field + "at", knees[i].at);
    RequireOption(std::abs(knees[i].side) == 1, "SpringLaw: " + field + "side", knees[i].side, "+1 or -1");
    RequireFinite(field + "stiffness", knees[i].stiffness);
    RequireFinite(field + "cubic", knees[i].cubic);
  }
}

}  // namespace fourpost
