#include "analysis/files/recording/unique_names.h"

#include <map>
#include <set>

namespace fourpost {

void MakeNamesUnique(Recording& recording) {
  std::map<std::string, int> times;
  for (std::size_t i = 0; i < recording.channels.size(); ++i) {
    RecordingChannel& channel = recording.channels[i];
    if (channel.name.empty()) channel.name = "channel " + std::to_string(i + 1);
    ++times[channel.name];
  }
  std::set<std::string> taken;
  for (RecordingChannel& channel : recording.channels) {
    if (times[channel.name] > 1) {
      if (!channel.group.empty()) channel.name = channel.group + "/" + channel.name;
      else if (!channel.point.empty()) channel.name += " " + channel.point;
    }
    const std::string name = channel.name;
    for (int number = 2; !taken.insert(channel.name).second; ++number)
      channel.name = name + " " + std::to_string(number);
  }
}

}  // namespace fourpost
