#pragma once

#include "analysis/text/finding.h"

// Why a simulation ends.
namespace fourpost {

inline const Finding kForcesNotFound{
    "forces-not-found", Severity::kError, "the forces of the vehicle's elements were not found at t = {}",
    "take a shorter step, or less motion if a hydraulic damper's piston meets its end"};
inline const Finding kMotionDiverges{"motion-diverges", Severity::kError,
                                     "the motion grows beyond all bounds before t = {}"};
inline const Finding kMotionNotFound{"motion-not-found", Severity::kError,
                                     "the motion of the full system was not found at t = {}"};
inline const Finding kFullDeparts{"full-departs", Severity::kError,
                                  "the full system does not follow the reduced model at t = {}", "take a shorter step"};
inline const Finding kChamberCloses{"chamber-closes", Severity::kError, "a chamber of a hydraulic damper closes"};

}  // namespace fourpost
