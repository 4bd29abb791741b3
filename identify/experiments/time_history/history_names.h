#pragma once

#include <string>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/time_history/history_study.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Whether the posts, actuators and sensors that a history names are the vehicle's, every post has a channel, and the
/// vehicle can be released as stated; else findings of the study's `file`.
bool CheckHistoryNames(const StudyHistory& study, const std::string& file, const Vehicle& vehicle,
                       Diagnostics& diagnostics);

}  // namespace fourpost
