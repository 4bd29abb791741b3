#pragma once

#include <string>
#include <vector>

#include "identify/experiments/time_history/measured_history.h"

namespace fourpost {

/// MeasuredSignal::loudest of each.
void FindLoudest(std::vector<MeasuredSignal>& signals);

/// A signal that was taken out of a history, its rms and the largest of its kind, with units.
struct MotionlessSignal {
  std::string name;
  std::string rms;
  std::string largest_rms;
  /// Of the study.
  int line = 0;
};

/// Takes out the signals that do not move beside others of their kind or beside the posts: their weights would be those
/// of rounding. Constant ones stay, which are faults.
std::vector<MotionlessSignal> TakeMotionless(MeasuredHistory& history);

}  // namespace fourpost
