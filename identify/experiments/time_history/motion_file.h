#pragma once

#include <string>
#include <vector>

#include "identify/experiments/recorded_motion.h"
#include "identify/experiments/time_history/history_simulation.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Which samples to keep, every n-th of them: 60 a second or fewer, so few that a recording has no more than 60000
/// numbers. `columns`: posts and coordinates together.
Eigen::Index FrameStride(const MeasuredHistory& history, Eigen::Index columns);

/// As comma-separated text: a row of names, `recording`, `time_s`, `post_NAME_m` for each post of the vehicle, and
/// `coordinate_1` and so on; then a row per frame.
std::string MotionCsv(const Vehicle& vehicle, const std::vector<RecordedHistory>& histories);

/// Reads that back. Throws FaultyInput: no such text, other posts than the vehicle's, frames not evenly spaced.
std::vector<RecordedHistory> ReadMotionCsv(const std::string& text, const std::string& file, const Vehicle& vehicle);

}  // namespace fourpost
