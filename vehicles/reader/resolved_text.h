#pragma once

#include <filesystem>
#include <string>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Vehicle::text with every attribute of our tags that is left out and has a default written out behind those that are
/// given, and one comment on top that says so; all else is kept byte for byte. What the file says by `fp:mirror` or in
/// Drake's tags stands as it is. The text is meant for a file in `folder`: mesh files are named relative to it. Reading
/// it gives the same vehicle. Throws std::invalid_argument for a vehicle without a text.
std::string ResolvedText(const Vehicle& vehicle, const std::filesystem::path& folder);

}  // namespace fourpost
