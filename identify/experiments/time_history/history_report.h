#pragma once

#include "identify/experiments/experiment_report.h"

namespace fourpost {

/// Of time histories: history.csv, validation.csv and motion.csv of a fit's folder.
const ExperimentReport& HistoryReport();

}  // namespace fourpost
