#pragma once

#include "identify/experiments/experiment_report.h"

namespace fourpost {

/// Of stepped sines: response.csv of a fit's folder.
const ExperimentReport& FourPostReport();

}  // namespace fourpost
