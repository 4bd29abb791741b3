#pragma once

#include <string>

#include "vehicles/engine/history_solver.h"
#include "vehicles/engine/steady_response.h"

namespace fourpost {

/// "0.05 %"
std::string Percent(double share, int digits);

/// What an answer over time says of its integration, and of linear kinematics: two sentences at most, each on a line.
std::string EngineText(const HistoryEngine& by);

/// What the answer to a recording of a stepped sine says of linear kinematics, and which engine it is.
std::string EngineText(const std::string& recording, const SteadyResponse& answer);

/// What a fit says of a history: how far linear kinematics are off at the fitted point, and what came of it.
std::string FitEngineText(const std::string& recording, const HistoryEngine& by);

/// "linear kinematics are off by 4.6 % rms (F_tyre), which shows (0.6 %)"
std::string KinematicsText(const HistoryDifference& error);

/// "linear kinematics are off by at most 0.03 dB (a_axle, 12 Hz) and 0.2 deg (a_body, 1.5 Hz)"
std::string KinematicsText(const KinematicsError& error);

}  // namespace fourpost
