#pragma once

#include "vehicles/laws/dashpot_law.h"
#include "vehicles/laws/spring_law.h"

namespace fourpost {

/// Dashpot in series with a spring (mount, oil, rubber): force f = spring(x) = dashpot(v - dx/dt), v the extension rate
/// of both together [m/s], x the spring's extension [m], the state. Source: thesis table 3.3.1, model 3; with a cubic
/// spring model 4, with a smooth dashpot model 5. Dashpot and spring must strictly increase.
struct SeriesDamper {
  DashpotLaw dashpot;
  SpringLaw spring;

  double Force(double x) const { return spring.Force(x); }

  /// dx/dt [m/s].
  double SpringRate(double v, double x) const { return v - dashpot.Velocity(Force(x)); }
};

}  // namespace fourpost
