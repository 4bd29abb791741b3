#pragma once

#include <span>
#include <vector>

#include "analysis/frequency_response/tone_track.h"

namespace fourpost {

/// A time in which a tone keeps its frequency and amplitude, in samples; its ends are good to about a cycle.
struct Dwell {
  double start = 0;
  double end = 0;
  double cycles_per_sample = 0;
  double amplitude = 0;

  double cycles() const { return (end - start) * cycles_per_sample; }
};

/// Dwells of a stepped sine: stretches in which the phase is a straight line of time and the amplitude constant, both
/// within what noise allows, for four cycles at least, and longer than a sweep's that only looks straight: within a
/// dwell the frequency changes by less than a third of what it changes by to the next one. Those below half a per cent
/// of the largest amplitude are the rig at rest. In order. They are looked for in the signal's track and in its
/// SharpTrack(), whose shorter windows also see dwells of four to eight cycles, where there is little noise.
std::vector<Dwell> FindDwells(std::span<const double> signal, std::span<const TonePoint> track);

/// The share of the track's time, of that with a tone in it, that lies in dwells; 0 without a tone.
double ShareInDwells(std::span<const TonePoint> track, std::span<const Dwell> dwells);

/// The share of the track's time in which the tone explains most of the variance; about 1 of a sweep.
double TonalShare(std::span<const TonePoint> track);

}  // namespace fourpost
