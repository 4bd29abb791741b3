#pragma once

#include "analysis/text/finding.h"

// How loop closures lock a vehicle.
namespace fourpost {

inline const Finding kLoopsRigid{"loops-rigid", Severity::kError,
                                 "the loops lock the vehicle, {} cannot move against each other{} because of {}",
                                 "correct {}, or put an fp:bushing in place of {}"};
inline const Finding kLoopsWheel{"loops-wheel", Severity::kError,
                                 "the loops lock the vehicle, {} of {} against {} is impossible{} because of {}",
                                 "correct {}, or put an fp:bushing in place of {}"};
inline const Finding kLoopsDeadCentre{
    "loops-singular", Severity::kError,
    "the loops lock the vehicle, {} is free in the design pose only and cannot go on because of {}",
    "correct {}, or put an fp:bushing in place of {}"};
inline const Finding kLoopsStiff{"loops-stiff", Severity::kError,
                                 "the loops lock the vehicle, a motion of some millimetres is impossible because of {}",
                                 "correct {}, or put an fp:bushing in place of {}"};

}  // namespace fourpost
