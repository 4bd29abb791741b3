#pragma once

#include <vector>

#include "identify/experiments/experiment_report.h"
#include "identify/experiments/four_post/response_table.h"

namespace fourpost {

/// What to measure beside these channels.
ReportRemarks ResponseRemarks(const std::vector<ComparedChannel>& channels);

}  // namespace fourpost
