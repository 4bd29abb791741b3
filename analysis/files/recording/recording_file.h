#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "analysis/files/recording/recording.h"
#include "analysis/text/found.h"

namespace fourpost {

/// An open file of signals: what its header says, and the samples of one channel at a time, so that a file may be
/// larger than memory. Functions throw RecordingFault.
class RecordingFile {
 public:
  virtual ~RecordingFile() = default;

  /// Channels without their samples.
  const Recording& header() const { return header_; }
  /// What it says that is not read, as warnings.
  const std::vector<Found>& remarks() const { return remarks_; }

  virtual std::vector<double> Values(std::size_t channel) const = 0;
  /// Of a channel with a clock or a step, in s.
  std::vector<double> Times(std::size_t channel) const;
  /// With all samples.
  Recording ReadAll() const;

 protected:
  /// Of a channel with a clock, in s.
  virtual std::vector<double> ClockTimes(std::size_t channel) const;

  Recording header_;
  std::vector<Found> remarks_;
};

}  // namespace fourpost
