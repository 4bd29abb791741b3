#pragma once

#include <string>
#include <utility>
#include <vector>

#include "identify/experiments/experiment_report.h"

namespace fourpost {

/// Several runs of fits side by side as one self-contained HTML file: names of their folders, and what those hold.
/// Throws FaultyInput for a run that is no fit's, and nlohmann::json::exception for one that is not understood.
std::string ComparisonPage(std::vector<std::pair<std::string, RunContents>> folders, ExperimentReports experiments);

}  // namespace fourpost
