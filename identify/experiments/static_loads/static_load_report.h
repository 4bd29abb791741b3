#pragma once

#include "identify/experiments/experiment_report.h"

namespace fourpost {

/// Of loads under the tyres at rest, which result.json lists.
const ExperimentReport& StaticLoadReport();

}  // namespace fourpost
