#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "identify/report/compared_run.h"

namespace fourpost {

/// What the scripts overlay, of every channel that two runs or more have of the same recording: measured once, and a
/// line per run. A run whose measurement is another one, as of another window, has no line there.
/// analysis/report/README.md describes the shape. Throws FaultyInput.
nlohmann::ordered_json ComparisonCurves(const std::vector<ComparedRun>& runs);

}  // namespace fourpost
