#include "analysis/files/recording/recording_file.h"

namespace fourpost {

std::vector<double> RecordingFile::ClockTimes(std::size_t) const { return {}; }

std::vector<double> RecordingFile::Times(std::size_t channel) const {
  const RecordingChannel& head = header_.channels[channel];
  if (head.clock) return ClockTimes(channel);
  std::vector<double> times(head.step_s > 0 ? head.samples : 0);
  for (std::size_t k = 0; k < times.size(); ++k) times[k] = head.start_s + head.step_s * static_cast<double>(k);
  return times;
}

Recording RecordingFile::ReadAll() const {
  Recording all = header_;
  for (std::size_t i = 0; i < all.channels.size(); ++i) {
    all.channels[i].values = Values(i);
    if (all.channels[i].clock) all.channels[i].times_s = ClockTimes(i);
  }
  return all;
}

}  // namespace fourpost
