#pragma once

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// The condensed model at the vehicle's values. Throws FaultyInput about "--set" where these do not go together: the
/// file's own have been checked against each other.
CondensedModel CondensedAtValues(const Vehicle& vehicle);

}  // namespace fourpost
