#pragma once

#include <string>
#include <vector>

#include "analysis/measured_response/posts_by_name.h"
#include "analysis/measured_response/stated_unit.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// In place of what recordings say: units of channels, and which are those of posts.
struct DraftStatements {
  std::vector<StatedUnit> units = {};
  std::vector<PostChannel> posts = {};
};

/// Throws FaultyInput where one names no post of the vehicle; before a file is read by them.
void CheckStatedPosts(const DraftStatements& stated, const Vehicle& vehicle);

/// Throws FaultyInput where one names none of these channels.
void CheckStatements(const DraftStatements& stated, const std::vector<std::string>& channels);

}  // namespace fourpost
