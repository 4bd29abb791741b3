#pragma once

#include "analysis/text/finding.h"

// What can be wrong where additions to a fitted vehicle are looked for.
namespace fourpost {

inline const Finding kSuggestPointFailed{"suggest-point-failed", Severity::kError,
                                         "the model cannot be evaluated at the fitted values of the run",
                                         "check vehicle.urdf of the run with `fourpost check`"};

inline const Finding kSuggestPostNoise{
    "suggest-post-noise", Severity::kWarning,
    "noise of the recorded posts makes up most of the residuals, and additions may only imitate it",
    "record the posts with less noise, or take their commanded motion"};

}  // namespace fourpost
