#pragma once

#include <span>
#include <vector>

#include "analysis/frequency_response/dwells.h"
#include "analysis/frequency_response/rig_signals.h"

namespace fourpost {

/// A channel's reading where nothing moves, in its unit.
struct RestLevel {
  double mean = 0;
  /// Of the mean, by the scatter of tenths of a second.
  double variance = 0;
};

struct Rest {
  /// Of every channel; empty where the posts move from the start.
  std::vector<RestLevel> levels;
  /// Then by how much in the first half second, at that frequency or, with 0, from its begin to its end; and what
  /// counts as rest.
  double motion = 0;
  double frequency_Hz = 0;
  double limit = 0;
};

/// Before the posts first move: in half a second at least they drift, and move at the frequencies of the dwells, by no
/// more than half a per cent of the largest amplitude and what noise allows. Other noise and hum up to a tenth of the
/// dwells' amplitudes (median) is none of theirs. Later pauses do not count: the vehicle still rings down in them.
Rest RestBefore(const RigSignals& signals, std::span<const Dwell> dwells);

}  // namespace fourpost
