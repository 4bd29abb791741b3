#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/study_file/channel_source.h"

namespace fourpost {

/// Warnings about channels of recordings, each at its line of a study.
class ChannelWarnings {
 public:
  using Channels = std::vector<std::pair<std::string, ChannelSource>>;

  /// `channels`: the study's; all must outlive this object.
  ChannelWarnings(std::string file, const Channels& channels, Diagnostics& diagnostics);

  void Add(const std::string& channel, const std::string& message);
  /// `message` names its channels itself; at the line of `channel`.
  void AddAt(const std::string& channel, const std::string& message);

  /// What the study would take the channel from with the other sign, in its terms.
  std::string Turned(const std::string& channel) const;

 private:
  /// Null for one that the study does not have.
  const ChannelSource* Find(const std::string& channel) const;

  std::string file_;
  const Channels& channels_;
  Diagnostics& diagnostics_;
};

}  // namespace fourpost
