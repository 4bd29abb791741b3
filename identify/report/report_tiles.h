#pragma once

#include <string>
#include <vector>

#include "identify/report/fit_overview.h"
#include "identify/report/run_result.h"

namespace fourpost {

/// A word and four figures, HTML: the misfit against 1, the worst channel with a link to it, channels that the model
/// predicts, and parameters that are known to a tenth.
std::string TilesHtml(const FitOverview& overview, const std::vector<ReportedParameter>& parameters);

}  // namespace fourpost
