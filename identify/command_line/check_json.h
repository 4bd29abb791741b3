#pragma once

#include <optional>
#include <string>

#include "analysis/text/diagnostics.h"
#include "identify/command_line/checked_vehicle.h"

namespace fourpost {

/// What `fourpost check --json` prints. Units stand in the keys, angles in rad; what is not known is null, and so are a
/// rate without bound and the line of a finding about the file as a whole. Of a vehicle with a fault the findings only.
std::string CheckJson(const std::optional<CheckedVehicle>& checked, const Diagnostics& findings);

}  // namespace fourpost
