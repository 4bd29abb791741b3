#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "identify/draft/channel_match.h"
#include "identify/draft/drafted_preparation.h"

namespace fourpost {

/// Lines `start`, `end` and `release` of an entry of a study, for the release of this number in a recording: from the
/// first sample that leaves its rest until half a second after the motion has died away; `at rest` where the vehicle
/// rested before, else `estimated`. A comment says what stood above its rest [mm], and of what it was held by, were it
/// the displacement that stood highest. Where the recording shows no release, one line for the user to complete.
std::string ReleaseLines(const DraftedPreparation& preparation, const std::vector<ChannelMatch>& matches,
                         std::size_t number);

}  // namespace fourpost
