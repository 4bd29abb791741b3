#pragma once

#include <string>

#include "vehicles/engine/history_solver.h"
#include "vehicles/engine/steady_response.h"

namespace fourpost {

/// "0.05 %"
std::string Percent(double share, int digits);

/// Summary of a time history's integration error and of linear kinematics: at most two sentences, each on a line.
std::string EngineText(const HistoryEngine& by);

/// Summary of linear kinematics for a stepped-sine recording, with the engine.
std::string EngineText(const std::string& recording, const SteadyResponse& answer);

/// Summary of a history in a fit: the error of linear kinematics at the fitted point, and its correction.
std::string FitEngineText(const std::string& recording, const HistoryEngine& by);

/// "linear kinematics are off by 4.6 % rms (F_tyre), above the visible limit (0.6 %)"
std::string KinematicsText(const HistoryDifference& error);

/// "linear kinematics are off by at most 0.03 dB (a_axle, 12 Hz) and 0.2 deg (a_body, 1.5 Hz)"
std::string KinematicsText(const KinematicsError& error);

}  // namespace fourpost
