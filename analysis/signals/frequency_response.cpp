#include "analysis/signals/frequency_response.h"

#include <algorithm>

namespace fourpost {

const ChannelResponse* FrequencyResponse::Find(const std::string& channel) const {
  const auto found = std::find_if(channels.begin(), channels.end(),
                                  [&](const ChannelResponse& candidate) { return candidate.name == channel; });
  return found == channels.end() ? nullptr : &*found;
}

}  // namespace fourpost
