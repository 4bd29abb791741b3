#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/diagnostics.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Indices of the sensors asked for, each once, in the order of the names; all where there are no names. Adds an error
/// about "--channels" for each name that no sensor has.
std::vector<std::size_t> ChosenSensors(const std::vector<std::string>& names, const Vehicle& vehicle,
                                       Diagnostics& diagnostics);

}  // namespace fourpost
