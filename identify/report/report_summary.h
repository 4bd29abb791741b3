#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/experiments/experiment_report.h"
#include "identify/report/fit_overview.h"
#include "identify/report/run_result.h"

namespace fourpost {

/// What a run found, in plain words and with the remarks of its experiments, as HTML: how it ended, what fits and what
/// does not, what the data determine and what not, and what to measure next.
std::string SummaryHtml(const nlohmann::json& result, const FitOverview& overview,
                        const std::vector<ReportedParameter>& parameters, const ReportRemarks& remarks);

}  // namespace fourpost
