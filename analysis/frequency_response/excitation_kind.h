#pragma once

#include <span>
#include <vector>

#include "analysis/frequency_response/dwells.h"
#include "analysis/frequency_response/tone_track.h"

namespace fourpost {

/// How posts were moved.
enum class ExcitationKind { kStepped, kSweep, kRandom, kMultisine };

/// Of a post's signal: stepped, where dwells are more than half of the time in which there is a tone; a sweep, where a
/// tone explains the motion nine tenths of the time; else a multisine, where the signal repeats itself (PeriodOf); else
/// random.
ExcitationKind KindOf(std::span<const double> post, std::span<const TonePoint> track, std::span<const Dwell> dwells);

}  // namespace fourpost
