#pragma once

#include <string>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/time_history/measured_history.h"

namespace fourpost {

/// Warns of signals that drift beside their motion, see SlowDrift(), at their lines of the study. Where a post drifts as
/// well the vehicle may follow it, and a vehicle that was let go creeps: then nothing is said.
void ReportDrifts(const MeasuredHistory& history, const std::string& study_file, Diagnostics& diagnostics);

}  // namespace fourpost
