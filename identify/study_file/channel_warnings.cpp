#include "identify/study_file/channel_warnings.h"

#include <algorithm>
#include <utility>

#include "identify/study_file/channel_source_text.h"

namespace fourpost {

ChannelWarnings::ChannelWarnings(std::string file, const Channels& channels, Diagnostics& diagnostics)
    : file_(std::move(file)), channels_(channels), diagnostics_(diagnostics) {}

void ChannelWarnings::Report(const Finding& finding, const std::string& channel,
                             const std::vector<std::string>& words) {
  const ChannelSource* const source = Find(channel);
  diagnostics_.Report(finding, {file_, source == nullptr ? 0 : source->line}, words);
}

std::string ChannelWarnings::Turned(const std::string& channel) const {
  const ChannelSource* const found = Find(channel);
  ChannelSource source = found != nullptr ? *found : ChannelSource{.channels = {channel}};
  for (SourceChannel& one : source.channels) one.factor = -one.factor;
  return channel + ": " + SourceText(source);
}

const ChannelSource* ChannelWarnings::Find(const std::string& channel) const {
  const auto found =
      std::find_if(channels_.begin(), channels_.end(), [&](const auto& entry) { return entry.first == channel; });
  return found == channels_.end() ? nullptr : &found->second;
}

}  // namespace fourpost
