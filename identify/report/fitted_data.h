#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/experiments/experiment_report.h"

namespace fourpost {

/// What the costs of two runs must share to be compared: the recordings by their bytes, what is taken from them, the
/// deviations that weigh them, and the loss. From result.json of a fit and the study beside it. Settings are as
/// written: studies that write one setting in two ways differ. What an older run does not hold is null.
nlohmann::json FittedData(const RunFolder& run, ExperimentReports experiments);

/// Of the bytes of the recordings that were fitted, sorted.
std::vector<std::string> FittedDigests(const nlohmann::json& result);

}  // namespace fourpost
