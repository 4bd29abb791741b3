#pragma once

#include <nlohmann/json.hpp>

#include "identify/experiments/recorded_motion.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// The vehicle at its file's values for a viewer: links with poses and shapes, elements between points of links, how
/// each link moves per unit of the independent coordinates s, modes as s, and s as it answers to the posts' motions at
/// each frequency (of displacement, per unit of the reference post) and over time. analysis/report/README.md describes
/// the shape. A mesh that cannot be read is left out and named under "missing". Throws FaultyInput when the vehicle
/// cannot be assembled or held, and std::invalid_argument for histories of other coordinates.
nlohmann::ordered_json SceneJson(const Vehicle& vehicle, const RecordedMotions& motions);

}  // namespace fourpost
