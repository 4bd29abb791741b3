#pragma once

#include <span>
#include <vector>

#include "analysis/frequency_response/dwells.h"
#include "analysis/frequency_response/tone_track.h"

namespace fourpost {

/// How posts were moved.
enum class ExcitationKind { kStepped, kSweep, kRandom, kMultisine };

/// Of a post's signal. A multisine repeats itself (PeriodOf) and has tones together: one at a time explains less than
/// nine tenths of its power; or, where most of this is within a third of an octave, lines beside the strongest and its
/// harmonics have a hundredth of it. Else stepped, where dwells are more than half of the time in which there is a
/// tone, and one tone explains nine tenths of the power in them; a sweep, where a tone explains the motion nine tenths
/// of the time; else random.
ExcitationKind KindOf(std::span<const double> post, std::span<const TonePoint> track, std::span<const Dwell> dwells);

}  // namespace fourpost
