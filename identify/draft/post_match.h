#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/measured_response/posts_by_name.h"
#include "identify/draft/file_reading.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Takes the channels of posts out of a reading's: those `stated` that it has, else by what names say; of one post the
/// only channel that is named as one.
void MatchPosts(const Vehicle& vehicle, const std::vector<PostChannel>& stated, FileReading& reading);

/// A displacement beside those of posts that is nearly called as one, and what it is nearly called.
std::pair<std::string, std::string> MisspeltPost(const FileReading& reading);

/// Which posts have no channel, and how a channel is called so that it is found.
std::string PostsMissing(const Vehicle& vehicle, const FileReading& reading);

/// Channels that are of no use as the file has no unit for them, and how to state one; empty: there are none.
std::string WithoutUnit(const FileReading& reading);

}  // namespace fourpost
