#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/report/fit_overview.h"
#include "identify/report/run_result.h"

namespace fourpost {

/// Start, value, deviation, and the interval, in numbers and as a bar inside the bounds. `why_none`: where no parameter
/// has a deviation, the reason, text; the columns of deviations are left out then. `confidence`: of the intervals, as
/// the run states it; empty of runs of older versions.
std::string ParameterTableHtml(const std::vector<ReportedParameter>& parameters, const std::string& why_none,
                               const std::string& confidence = "");

/// Why intervals are as wide as they are, and what would make them narrower; empty of runs that do not say.
std::string IntervalBasisHtml(const std::vector<ReportedParameter>& parameters, const nlohmann::json& result,
                              const FitOverview& overview);

}  // namespace fourpost
