#pragma once

#include <span>
#include <vector>

#include "analysis/frequency_response/dwells.h"

namespace fourpost {

/// Dwells of frequencies that are known, in cycles per sample, rising, which look like a sweep: in steps
/// of a per cent or two. Each is a stretch of SharpTrack() whose phase turns, by a straight line over two cycles,
/// nearer to one of the frequencies than half of the way to the next and than 20 %; of a single one, to 5 %. A cycle
/// and a half at least. Motions below half a per cent of the largest amplitude are the rig at rest. In order.
std::vector<Dwell> DwellsOfFrequencies(std::span<const double> signal, std::span<const TonePoint> track,
                                       std::span<const double> cycles_per_sample);

}  // namespace fourpost
