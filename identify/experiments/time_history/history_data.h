#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/time_history/history_study.h"
#include "identify/experiments/time_history/measured_history.h"
#include "identify/study_file/control.h"
#include "identify/study_file/left_out_recording.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Reads the recordings and maps their channels to the vehicle's sensors and posts. Adds every fault to `diagnostics`;
/// nothing when there was an error.
std::optional<std::vector<MeasuredHistory>> LoadHistories(const std::vector<StudyHistory>& histories,
                                                          const std::string& study_file, const Vehicle& vehicle,
                                                          Diagnostics& diagnostics, const Control& control = {});

/// Likewise those that a fit does not see; each that has a fault is left out, with a warning, and added to `left_out`.
std::vector<MeasuredHistory> LoadValidation(const std::vector<StudyHistory>& histories, const std::string& study_file,
                                            const Vehicle& vehicle, Diagnostics& diagnostics,
                                            std::vector<LeftOutRecording>& left_out, const Control& control = {});

}  // namespace fourpost
