#pragma once

#include <span>
#include <vector>

#include "analysis/frequency_response/dwells.h"

namespace fourpost {

/// Dwells of frequencies that are known, in cycles per sample, rising. Stretches of SharpTrack() are of the one to
/// which the slope of the phase over two cycles is nearest, nearer than half of the way to the next and than 20 %; of a
/// single one, than 5 %: also where steps are of a per cent or two and look like a sweep. Dwells of `found`
/// (FindDwells()), whose ends are better known, count before stretches, where they are nearer to a frequency than a
/// quarter of the way to the next and do not lie astride two. A cycle and a half at least. Motions below half a per
/// cent of the largest amplitude are the rig at rest. In order.
std::vector<Dwell> DwellsOfFrequencies(std::span<const double> signal, std::span<const TonePoint> track,
                                       std::span<const Dwell> found, std::span<const double> cycles_per_sample);

}  // namespace fourpost
