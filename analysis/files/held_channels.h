#pragma once

#include <span>
#include <vector>

#include "analysis/files/recorded_table.h"
#include "analysis/files/time_recording.h"

namespace fourpost {

/// Makes NaN of samples that a logger held, see HeldStretches(), and says so. Of each channel the stretches, from the
/// last good sample before to the first behind.
std::vector<std::vector<BridgedGap>> LeaveOutHeld(const RecordedTable& table, std::span<const RecordedChannel> wanted,
                                                  std::span<const double> times,
                                                  std::vector<std::vector<double>>& channels,
                                                  Diagnostics& diagnostics);

/// How much of a gap lies in none of these [s].
double NotHeld_s(const BridgedGap& gap, const std::vector<BridgedGap>& held);

}  // namespace fourpost
