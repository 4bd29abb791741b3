#pragma once

#include "identify/experiments/experiment_report.h"

namespace fourpost {

/// Of a damper on its bench: bench.csv of a fit's folder.
const ExperimentReport& BenchReport();

}  // namespace fourpost
