#include "identify/study_file/measured_channels.h"

#include <algorithm>

#include "analysis/text/diagnostics.h"

namespace fourpost {

std::string KeepMeasured(const std::filesystem::path& recording, const std::vector<std::string>& names,
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
  return left_out;
}

}  // namespace fourpost
