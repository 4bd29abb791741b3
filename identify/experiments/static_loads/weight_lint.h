#pragma once

#include "analysis/text/diagnostics.h"
#include "identify/experiments/static_loads/static_loads.h"

namespace fourpost {

/// Static loads that no masses within their bounds make.
void LintWeights(const StaticLoadTest& static_loads, const Subject& subject, Diagnostics& diagnostics);

}  // namespace fourpost
