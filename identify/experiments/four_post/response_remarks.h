#pragma once

#include <vector>

#include "identify/experiments/experiment_report.h"
#include "identify/experiments/four_post/response_table.h"

namespace fourpost {

/// Where the model is farthest from these channels, and what to measure beside them.
ReportRemarks ResponseRemarks(const std::vector<ComparedChannel>& channels, bool is_wiring_cleared = false);

}  // namespace fourpost
