#pragma once

#include "analysis/text/finding.h"

// What can be wrong where additions to a fitted vehicle are looked for.
namespace fourpost {

inline const Finding kSuggestPointFailed{"suggest-point-failed", Severity::kError,
                                         "the model cannot be evaluated at the fitted values of the run",
                                         "check vehicle.urdf of the run with `fourpost check`"};

}  // namespace fourpost
