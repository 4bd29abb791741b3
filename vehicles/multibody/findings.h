#pragma once

#include "analysis/text/finding.h"

namespace fourpost {

inline const Finding kLoopOpen{
    "loop-open", Severity::kError,
    "the loop cannot be closed, the two points of {} are {} apart as written, and moving the "
    "bodies leaves {} of it",
    "correct their positions or the joints between them"};
inline const Finding kLoopStuck{
    "loop-stuck", Severity::kError,
    "the loop cannot be closed, the two points of {} are {} apart as written, and moving the "
    "bodies brings them no nearer",
    "correct their positions or the joints between them"};
inline const Finding kNotEvaluated{"not-evaluated", Severity::kError, "the vehicle cannot be evaluated at t = {} ({})",
                                   "check masses, rates and signs with `fourpost check`, or reduce the motion"};
inline const Finding kSimulationFailed{"simulation-failed", Severity::kError, "the simulation failed at t = {} ({})",
                                       "check masses, rates and signs with `fourpost check`, or reduce the motion"};

}  // namespace fourpost
