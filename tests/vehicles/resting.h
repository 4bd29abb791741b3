#pragma once

#include <vector>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// The vehicle in Simbody with these parameters, resting on its preloads.
inline Multibody Resting(const Vehicle& vehicle, const std::vector<double>& values) {
  Multibody multibody(vehicle);
  multibody.SetParameters(values, CondensedVehicle(vehicle).PreloadsAt(values));
  return multibody;
}

/// At its file's values.
inline Multibody Resting(const Vehicle& vehicle) { return Resting(vehicle, vehicle.ParameterValues()); }

}  // namespace fourpost
