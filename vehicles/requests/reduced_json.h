#pragma once

#include <string>

#include "vehicles/condensed/reduced_vehicle.h"

namespace fourpost {

/// A reduced vehicle as JSON, SI, all digits: ReducedData field by field, numbers that follow a parameter as
/// {"parameter": name, "factor": f}, and its linear state space at the file's values.
std::string ReducedJson(const ReducedVehicle& vehicle);

}  // namespace fourpost
