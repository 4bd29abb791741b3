#pragma once

#include "analysis/text/finding.h"

// Why an engine has no answer, or no estimate of its error.
namespace fourpost {

inline const Finding kInterrupted{"interrupted", Severity::kWarning, "interrupted before it was computed",
                                  "run it again"};
inline const Finding kNothingToCompare{
    "nothing-to-compare", Severity::kWarning,
    "the full harmonic balance converged at no frequency at which the linearised one did", "try smaller amplitudes"};
inline const Finding kOneStepOnly{"one-step-only", Severity::kError, "there are no two step sizes to compare",
                                  "give a higher sampling rate"};

}  // namespace fourpost
