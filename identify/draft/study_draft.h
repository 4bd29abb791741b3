#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/process/work_hooks.h"
#include "analysis/text/diagnostics.h"
#include "identify/draft/channel_match.h"
#include "identify/draft/drafted_channels.h"
#include "identify/draft/file_reading.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A file that a study was drafted from.
struct DraftedFile {
  std::filesystem::path path;
  /// What is made of it: "recordings", "histories", "static_loads", or why nothing is.
  std::string use;
  bool is_used = false;
  /// Not used, as a post's channel is misspelt.
  bool has_misspelt_post = false;
  /// What of the vehicle its channels were matched to, without posts.
  std::vector<ChannelMatch> matches = {};
  /// All channels, posts first.
  std::vector<DraftedChannel> channels = {};
  /// Name of the first file whose channels are all the same and matched alike; empty: none before it.
  std::string same_as = {};
  /// Channels that nothing was matched to, and what has no channel.
  std::vector<std::string> channels_left = {};
  std::vector<std::string> sensors_left = {};
  /// The latter with what each measures.
  std::vector<std::string> without_channel = {};
};

struct StudyDraft {
  /// The study, with what is to be looked at as comments.
  std::string text;
  std::vector<DraftedFile> files;
  /// What loading it and checking its recordings found; errors are such that a fit would find.
  Diagnostics findings;
};

/// Drafts a study of a vehicle and recordings: stepped sines, as tables, frequency responses or dwells over time,
/// become `recordings`, other time histories `histories`, loads at rest `static_loads`. Posts and sensors are matched
/// to channels by MatchChannels(), with the responses of the vehicle as its file has it; the draft is then checked as
/// `fourpost info STUDY` does. `study`: where it will be written; paths are relative to its folder. Throws FaultyInput
/// where the vehicle cannot be assembled. `stated`: in place of what time histories have; also thrown where one
/// names no channel, or no post. `hooks`: shown which file is read, and the check, which takes seconds where a start
/// has to be estimated.
StudyDraft DraftStudy(const std::vector<std::filesystem::path>& files, const Vehicle& vehicle,
                      const std::filesystem::path& study, const DraftStatements& stated = {},
                      const WorkHooks& hooks = {});

}  // namespace fourpost
