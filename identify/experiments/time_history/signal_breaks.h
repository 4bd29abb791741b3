#pragma once

#include <string>
#include <vector>

#include "analysis/files/time_recording.h"
#include "analysis/text/diagnostics.h"
#include "identify/experiments/time_history/measured_history.h"

namespace fourpost {

/// Warns of signals with samples that stand out (Spikes) by more than the span of all others, at their lines of the study:
/// an impact that is sampled coarsely may be a spike, but it is no such one.
void ReportSpikes(const MeasuredHistory& history, const std::string& study_file, Diagnostics& diagnostics);

/// Between two samples where a post and a sensor of displacement jump at once, see Jumps(), as where rows are missing
/// and times were closed up: what the posts did there is not known. A step that a post was driven in moves no sensor of
/// displacement at once.
std::vector<BridgedGap> ClosedUpTimes(const MeasuredHistory& history);

}  // namespace fourpost
