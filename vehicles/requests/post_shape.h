#pragma once

#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Relative motion of each post (Excitation::shape): "heave", "pitch", "roll", "warp", see PostPattern, or the shares
/// of posts, "FL=1,FR=-1", of which one is 1 or -1; posts not named stand still. Adds an error about "--mode" for
/// invalid text, a pattern that the posts cannot make, an unknown post, and one named twice; the result is then
/// invalid. The vehicle must have a post.
std::vector<double> ReadPostShape(const std::string& mode, const Vehicle& vehicle, Diagnostics& diagnostics);

}  // namespace fourpost
