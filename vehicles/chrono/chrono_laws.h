#pragma once

#include <string>

#include "vehicles/chrono/chrono_node.h"
#include "vehicles/templates/axle_knowledge.h"

namespace fourpost {

/// Laws of Chrono's springs and shocks as tags of a vehicle file, with parameters named after the axle. Chrono gives
///   spring: push = preload - k (length - free length), or preload - curve(length - free length)
///   shock: push = -c v, -c v / (1 + d |v|) with d >= 0 of each direction, -curve(v), or a map over length and speed;
///     v: speed of extension
/// so that its curves are tensions over extension. Its stops, of Adams Car's example, are 100 N/mm + 0.06 N/mm^3 s^3
/// within 3 % up to 50 mm. Source: chrono/utils/ChForceFunctors.cpp, chrono/input_output/ChUtilsJSON.cpp.

/// `length`: as written.
KnownLaw ChronoSpring(const ChronoNode& spring, const std::string& axle, double length, const std::string& source);
KnownLaw ChronoShock(const ChronoNode& shock, const std::string& axle, double length, const std::string& source);
/// Nothing where it has none.
std::optional<KnownLaw> ChronoStops(const ChronoNode& spring, double length);

}  // namespace fourpost
