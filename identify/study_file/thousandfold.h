#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "identify/study_file/channel_source.h"

namespace fourpost {

/// Whether a ratio of sizes is nearer to a thousand, or to a thousandth, than a vehicle file is ever off: the unit of
/// one of the two is then wrong, such as mm taken for m. 1: a thousand, -1: a thousandth, 0: neither.
int ThousandfoldOf(double ratio);

/// The source as it is to be written where its channels come out a thousand times too large, `direction` 1, or too
/// small, -1: with the unit that was meant, else with a scale. `files`: where its channels are looked for, for their
/// units.
ChannelSource WithUnitMeant(ChannelSource source, int direction, const std::vector<std::filesystem::path>& files);

/// The same where the true readings are `times` the recorded ones and a unit is that much smaller or larger; empty where
/// there is none for one of its channels.
std::optional<ChannelSource> WithUnitOfTimes(ChannelSource source, double times,
                                             const std::vector<std::filesystem::path>& files);

/// "m" of the source's first channel: as stated, else as in the files; empty where it has none.
std::string StatedUnitOf(const ChannelSource& source, const std::vector<std::filesystem::path>& files);

}  // namespace fourpost
