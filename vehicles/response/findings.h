#pragma once

#include "analysis/text/finding.h"

// What a steady response shows or lacks.
namespace fourpost {

inline const Finding kTyrePulls{"tyre-pulls", Severity::kWarning,
                                "fp:tyre '{}' pulls on the ground in {} of {} {} of {}, down to {}",
                                "remove liftoff=\"false\" or reduce the motion"};
inline const Finding kStrokeExceeded{"stroke-exceeded", Severity::kError,
                                     "fp:post '{}' reaches {} up and down, but {} needs {}",
                                     "reduce the motion, or correct the post's stroke"};
inline const Finding kUsualStrokeExceeded{"usual-stroke-exceeded", Severity::kError,
                                          "fp:post '{}' reaches {} up and down, but {} needs {}",
                                          "reduce the motion, or give the stroke of your posts"};

inline const Finding kUnsteady{"unsteady", Severity::kError, "{} has no periodic motion within {}{}",
                               "try another amplitude, or use harmonic balance"};
inline const Finding kUnsteadyMode{"unsteady-mode", Severity::kError,
                                   "{} has no periodic motion within {}{}, mode '{}' is {}", "see `fourpost check`"};
inline const Finding kUnsteadyAmplitude{
    "unsteady-amplitude", Severity::kError,
    "{} has no periodic motion within {}{}, though the slowest mode, '{}' at {} with damping ratio {}, decays in {}; "
    "friction, stops or tyres that lift off may keep the motion from repeating",
    "try another amplitude"};
inline const Finding kUnsteadyDamping{
    "unsteady-damping", Severity::kError,
    "{} has no periodic motion within {}{}, mode '{}' at {} with damping ratio {} takes {} to decay",
    "see `fourpost check`, and give it damping or use harmonic balance, which need not wait"};

}  // namespace fourpost
