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

  /// At the line of `channel`.
  void Report(const Finding& finding, const std::string& channel, const std::vector<std::string>& words);

  /// The study's entry of the channel with the other sign.
  std::string Turned(const std::string& channel) const;

 private:
  /// Null for one that the study does not have.
  const ChannelSource* Find(const std::string& channel) const;

  std::string file_;
  const Channels& channels_;
  Diagnostics& diagnostics_;
};

}  // namespace fourpost
