#pragma once

#include <optional>
#include <string>

#include "identify/experiments/time_history/release.h"

namespace fourpost {

/// "estimated", "at rest", or readings above rest at which the vehicle was held: "z_body=50 mm,z_axle=estimated".
/// Nothing for other text.
std::optional<Release> ParseRelease(const std::string& text);

}  // namespace fourpost
