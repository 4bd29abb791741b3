#include "identify/lint/channel_warnings.h"

#include <algorithm>
#include <utility>

#include "identify/channel_source_text.h"

namespace fourpost {

ChannelWarnings::ChannelWarnings(std::string file, const Channels& channels, Diagnostics& diagnostics)
    : file_(std::move(file)), channels_(channels), diagnostics_(diagnostics) {}

void ChannelWarnings::Add(const std::string& channel, const std::string& message) {
  const ChannelSource* source = Find(channel);
  diagnostics_.Warning(file_, source ? source->line : 0, "'" + channel + "' " + message);
}

std::string ChannelWarnings::Turned(const std::string& channel) const {
  const ChannelSource* found = Find(channel);
  ChannelSource source = found ? *found : ChannelSource{.channels = {channel}};
  for (SourceChannel& one : source.channels) one.factor = -one.factor;
  return channel + ": " + SourceText(source);
}

const ChannelSource* ChannelWarnings::Find(const std::string& channel) const {
  const auto source =
      std::find_if(channels_.begin(), channels_.end(), [&](const auto& entry) { return entry.first == channel; });
  return source == channels_.end() ? nullptr : &source->second;
}

}  // namespace fourpost
