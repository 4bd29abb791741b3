#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "identify/report/compared_run.h"

namespace fourpost {

/// What the scripts overlay, of every channel that two runs or more have of the same recording: measured once, and a
/// line per run. A run whose measurement is another one, as of another window, has no line there. Throws FaultyInput.
std::vector<ComparedCurves> CurvesOf(const std::vector<ComparedRun>& runs, ExperimentReports experiments);

/// They with the runs' names and bands, in the shape of analysis/report/README.md.
nlohmann::ordered_json ComparisonJson(const std::vector<ComparedRun>& runs, const std::vector<ComparedCurves>& curves);

}  // namespace fourpost
