#include "identify/lint/channel_warnings.h"

#include <algorithm>
#include <utility>

namespace fourpost {

ChannelWarnings::ChannelWarnings(std::string file, const Channels& channels, Diagnostics& diagnostics)
    : file_(std::move(file)), channels_(channels), diagnostics_(diagnostics) {}

void ChannelWarnings::Add(const std::string& channel, const std::string& message) {
  const auto source =
      std::find_if(channels_.begin(), channels_.end(), [&](const auto& entry) { return entry.first == channel; });
  diagnostics_.Warning(file_, source == channels_.end() ? 0 : source->second.line, "'" + channel + "' " + message);
}

}  // namespace fourpost
