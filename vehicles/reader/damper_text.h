#pragma once

#include <span>
#include <string>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// The fp:damper of this name as it stands in Vehicle::text, with numbers in place of parameters, to be pasted into
/// another vehicle file. `parameters`: SI, in the order of Vehicle::parameters. Empty for a damper that an fp:mirror or
/// a tag of Drake makes, which has no element. Throws std::invalid_argument for a wrong number of values, and for a
/// vehicle without a text.
std::string DamperText(const Vehicle& vehicle, const std::string& damper, std::span<const double> parameters);

}  // namespace fourpost
