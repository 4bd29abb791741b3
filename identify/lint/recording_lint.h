#pragma once

#include "analysis/diagnostics.h"
#include "identify/loaded_study.h"

namespace fourpost {

/// What in a study's stepped-sine responses and static loads can hardly be so, as warnings: an accelerometer that does
/// not move with its body below 1 Hz, where that is rigid (its station is wrong by far, or its sign, or its scale); a
/// channel of another sign than the vehicle has; a load cell that feels a wheelpan the vehicle does not have, or the
/// other way round; static loads that no masses within their bounds make. Nothing for a study without any. Throws
/// FaultyInput when the vehicle cannot be assembled.
void LintRecordings(const LoadedStudy& study, Diagnostics& diagnostics);

}  // namespace fourpost
