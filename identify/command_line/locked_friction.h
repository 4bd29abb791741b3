#pragma once

#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/response/friction_lock.h"

namespace fourpost {

/// Adds a warning for each. `motion`: what does not make them slide, such as "heave".
void WarnOfLocked(const Vehicle& vehicle, const std::vector<LockedFriction>& locked, const std::string& motion,
                  Diagnostics& findings);

}  // namespace fourpost
