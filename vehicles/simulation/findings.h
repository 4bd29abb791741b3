#pragma once

#include "analysis/text/finding.h"

// Why a simulation ends.
namespace fourpost {

inline const Finding kForcesNotFound{
    "forces-not-found", Severity::kError, "the forces of the vehicle's elements were not found at t = {}",
    "take a shorter step, or less motion if a hydraulic damper's piston meets its end"};
inline const Finding kMotionDiverges{"motion-diverges", Severity::kError,
                                     "the motion grows beyond all bounds before t = {}",
                                     "see `fourpost check`, and check the signs of dampers"};
inline const Finding kMotionNotFound{"motion-not-found", Severity::kError,
                                     "the motion of the full system was not found at t = {}",
                                     "reduce the motion, or use `--engine reduced`"};
inline const Finding kFullDeparts{"full-departs", Severity::kError,
                                  "the full system does not follow the reduced model at t = {}", "take a shorter step"};
inline const Finding kReleaseOfMultibody{
    "release-of-multibody", Severity::kError, "the full geometry was not found along the motion after the release",
    "check how far the vehicle was held from rest; the reduced model answers with `--engine reduced`"};
inline const Finding kChamberCloses{"chamber-closes", Severity::kError, "a chamber of a hydraulic damper closes",
                                    "lengthen the oil column, or reduce the stroke"};

}  // namespace fourpost
