#pragma once

#include <utility>

#include "analysis/files/recording/recording_file.h"

namespace fourpost {

/// A recording whose samples are in memory, with those of its channels that are not even at `times_s`.
class MemoryRecording : public RecordingFile {
 public:
  explicit MemoryRecording(Recording recording) : all_(std::move(recording)) {
    header_ = all_;
    for (std::size_t i = 0; i < all_.channels.size(); ++i) {
      RecordingChannel& channel = header_.channels[i];
      channel.samples = channel.values.size();
      if (!channel.times_s.empty() && !channel.clock) channel.clock = i;
      channel.values.clear();
      channel.times_s.clear();
    }
  }

  std::vector<double> Values(std::size_t channel) const override { return all_.channels[channel].values; }

 protected:
  std::vector<double> ClockTimes(std::size_t channel) const override { return all_.channels[channel].times_s; }

 private:
  Recording all_;
};

}  // namespace fourpost
