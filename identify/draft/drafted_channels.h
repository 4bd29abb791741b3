#pragma once

#include <string>
#include <vector>

#include "identify/draft/channel_match.h"
#include "identify/draft/file_reading.h"

namespace fourpost {

/// A channel of a file, and what is known of its match.
struct DraftedChannel {
  enum class State { kSure, kLookAt, kUnmatched };

  std::string name;
  /// "post 'front'", "s_strut_front"; empty where it is not matched.
  std::string of = {};
  State state = State::kUnmatched;
  /// What to look at, or what would make it match.
  std::string why = {};

  bool operator==(const DraftedChannel&) const = default;
};

/// "sure", "look at", "unmatched"
const char* StateName(DraftedChannel::State state);

/// What is to be looked at of a match; empty where it is sure.
std::string DoubtOf(const ChannelMatch& match);

/// All channels of a file, posts and actuators first, with what each was matched to among `sought` or why to nothing.
std::vector<DraftedChannel> ChannelsOf(const FileReading& reading, const std::vector<ChannelMatch>& matches,
                                       const std::vector<SoughtChannel>& sought, const CorrelationOf& correlation);

/// What of `sought` has no channel, each with how one would be found: "a_body (an acceleration)".
std::vector<std::string> WithoutChannel(const std::vector<ChannelMatch>& matches,
                                        const std::vector<SoughtChannel>& sought);

}  // namespace fourpost
