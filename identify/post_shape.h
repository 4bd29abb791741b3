#pragma once

#include <string>
#include <vector>

#include "analysis/diagnostics.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// How far each post moves relative to the reference (Excitation::shape): "heave", "pitch", "roll", "warp", see
/// PostPattern, or the shares of posts, "FL=1,FR=-1", of which one is 1 or -1; posts not named stand still. Adds an
/// error about "--mode" for what cannot be read, a pattern that the posts cannot make, a post that the vehicle has not,
/// and one named twice; what it gives then counts for nothing. The vehicle has a post.
std::vector<double> ReadPostShape(const std::string& mode, const Vehicle& vehicle, Diagnostics& diagnostics);

}  // namespace fourpost
