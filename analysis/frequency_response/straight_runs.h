#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/frequency_response/tone_track.h"

namespace fourpost {

/// Points of a track whose phases lie on one line of time: a tone of one frequency.
struct StraightRun {
  std::size_t first = 0;
  std::size_t last = 0;
  double cycles_per_sample = 0;
  double amplitude = 0;
  /// By which the frequency changes from end to end, in cycles per sample.
  double drift = 0;
};

/// How a track is looked at.
struct RunRule {
  /// Windows of the track.
  double window_cycles = 3;
  /// Points that must lie on a line for a run to begin with.
  std::size_t seed = 6;
  /// What a phase may be off the line by beside noise, in radians.
  double tolerance_rad = 0.07;
  /// A tone that explains less of its window's variance does not count.
  double share = 0.5;
};

/// Runs in the order of time, none of which overlap. Each grows to both sides from points that lie straighter than all
/// that are in no run yet, so that it does not begin astride a step. Its amplitude stays within 10 % and what noise
/// allows. A point that noise moves does not end it: two in a row do.
std::vector<StraightRun> FindStraightRuns(std::span<const TonePoint> track, const RunRule& rule);

}  // namespace fourpost
