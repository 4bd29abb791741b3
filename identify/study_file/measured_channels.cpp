#include "identify/study_file/measured_channels.h"

#include <algorithm>

#include "identify/study_file/findings.h"

namespace fourpost {

void KeepMeasured(const std::filesystem::path& recording, const std::vector<std::string>& names,
                  std::vector<std::pair<std::string, ChannelSource>>& channels, Diagnostics& diagnostics) {
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
  if (channels.empty()) Refuse(kFittedChannelsMissing, {recording.string()});
  if (!left_out.empty()) diagnostics.Report(kSensorsNotMeasured, {recording.string()}, {left_out});
}

}  // namespace fourpost
