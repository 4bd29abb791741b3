#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Indices of the requested sensors, each once, in the order of the names; all if there are no names. Adds an error
/// about "--channels" for each unknown name.
std::vector<std::size_t> ChosenSensors(const std::vector<std::string>& names, const Vehicle& vehicle,
                                       Diagnostics& diagnostics);

}  // namespace fourpost
