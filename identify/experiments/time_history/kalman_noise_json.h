#pragma once

#include <filesystem>
#include <optional>

#include <nlohmann/json.hpp>

#include "identify/experiments/time_history/history_data.h"
#include "identify/experiments/time_history/kalman_predictor.h"

namespace fourpost {

/// "recording", "process_sd" of each coordinate, "sensor_sd" by the names of the signals; SI.
nlohmann::ordered_json KalmanNoiseJson(const MeasuredHistory& history, const KalmanNoise& noise);

/// Noise of the first recording as the result.json of a fit by prediction states it, for these signals; nothing where
/// it states none, or not that of all of them.
std::optional<KalmanNoise> ReadKalmanNoise(const std::filesystem::path& result, const MeasuredHistory& history);

}  // namespace fourpost
