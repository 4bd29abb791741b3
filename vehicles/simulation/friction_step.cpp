#include "vehicles/simulation/friction_step.h"

namespace fourpost {

void FrictionStep::Rest(double extension) {
  start_ = from_ = end_ = {.tension = 0, .extension = extension};
  stroke_ = law_.After(0, 0);
}

double FrictionStep::Tension(double extension) {
  from_ = start_;
  stroke_ = law_.After(from_.tension, extension - from_.extension);
  end_ = {stroke_.force, extension};
  return stroke_.force;
}

double FrictionStep::Departure(const DahlFriction& other) const {
  return other.After(from_.tension, end_.extension - from_.extension).force - end_.tension;
}

}  // namespace fourpost
