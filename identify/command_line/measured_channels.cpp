#include "identify/command_line/measured_channels.h"

#include <algorithm>
#include <cstdio>

#include "analysis/diagnostics.h"

namespace fourpost {

void KeepMeasured(const std::filesystem::path& recording, const std::vector<std::string>& names,
                  std::vector<std::pair<std::string, ChannelSource>>& channels) {
  const auto is_there = [&](const SourceChannel& channel) {
    return std::find(names.begin(), names.end(), channel.name) != names.end();
  };
  std::string left_out;
  std::erase_if(channels, [&](const std::pair<std::string, ChannelSource>& entry) {
    const std::vector<SourceChannel>& wanted = entry.second.channels;
    if (std::all_of(wanted.begin(), wanted.end(), is_there)) return false;
    left_out += (left_out.empty() ? "" : ", ") + entry.first;
    return true;
  });
  if (channels.empty()) {
    Diagnostics faults;
    faults.Error(recording.string(), 0, "has none of the channels that the model was fitted to");
    throw FaultyInput(faults);
  }
  if (!left_out.empty())
    std::fprintf(stderr, "not measured in %s, left out: %s\n", recording.filename().c_str(), left_out.c_str());
}

}  // namespace fourpost
