#pragma once

#include <string>
#include <vector>

#include "analysis/files/time_recording.h"
#include "identify/experiments/time_history/measured_history.h"

namespace fourpost {

/// Samples of a signal that stand out (Spikes) by more than the span of all others: an impact that is sampled coarsely
/// may be a spike, but it is no such one.
struct SpikedSignal {
  std::string name;
  /// Of the study.
  int line = 0;
  std::size_t count = 0;
  /// When the first is, and what it reads there, with its unit.
  double first_s = 0;
  std::string reading;
};
std::vector<SpikedSignal> SpikedSignals(const MeasuredHistory& history);

/// Between two samples where a post and a sensor of displacement jump at once, see Jumps(), as where rows are missing
/// and times were closed up: what the posts did there is not known. A step that a post was driven in moves no sensor of
/// displacement at once.
std::vector<BridgedGap> ClosedUpTimes(const MeasuredHistory& history);

}  // namespace fourpost
