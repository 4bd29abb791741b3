#pragma once

#include <string>
#include <vector>

namespace fourpost {

/// A post and the channel of its displacement.
struct PostChannel {
  std::string channel;
  std::string post;
};

/// Posts that the names of channels say.
struct NamedPosts {
  std::vector<PostChannel> posts;
  /// Commands of posts, beside channels of how these moved.
  std::vector<std::string> commands;
  /// Channels of one post, of which neither is a command.
  std::vector<std::vector<std::string>> alike;
  /// Not by "post" or a place alone.
  bool is_by_meaning = false;

  /// "posts by the names of their channels: 'Zyl_VL_ist' is FL, ..."; empty where these are plain.
  std::string InWords() const;
};

/// Posts among channels of a length: those that begin with "post", or else those that are named FL, FR, RL, RR, front,
/// rear, left or right and nothing more; called by what follows "post". Without any, those whose names mean a post,
/// such as "Zyl VL" or "actuator rear" (MeaningsOf()), called by their places. "act", "road" and "table" mean one where
/// they stand alone, and no name does that means a part of the vehicle as well. Of two channels at one place that which
/// is no command ("soll", "cmd", "ref", "drive", "demand", "target") is the post's own motion ("ist", "fbk", "act",
/// "meas").
NamedPosts PostsByName(const std::vector<std::string>& lengths);

/// What a channel beside these of posts is probably meant to be called, as "post_RR" of "psot_RR" beside "post_RL": one
/// of them with the place of a post that is none of theirs. Empty where no such name is near.
std::string NearlyPost(const std::string& name, const std::vector<std::string>& posts);

}  // namespace fourpost
