#pragma once

#include <filesystem>
#include <string>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Vehicle::text with all defaults written out: every missing attribute of an `fp:` tag that has a default is added
/// after the given ones, and a comment on top says so. All else is kept byte for byte, including `fp:mirror` and
/// Drake's tags. The text is meant for a file in `folder`: mesh files are named relative to it. Reading it gives the
/// same vehicle. Throws std::invalid_argument for a vehicle without a text.
std::string ResolvedText(const Vehicle& vehicle, const std::filesystem::path& folder);

}  // namespace fourpost
