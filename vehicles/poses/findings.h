#pragma once

#include "analysis/text/finding.h"

// What keeps a suspension from its travel.
namespace fourpost {

inline const Finding kNoWheels{"no-wheels", Severity::kError, "the vehicle has no fp:tyre, so it has no wheel to move",
                               "add one at the centre of each wheel"};
inline const Finding kWheelsDoNotTravel{"wheels-do-not-travel", Severity::kError,
                                        "no wheel can move up and down against the chassis",
                                        "give the wheels' links joints of their own; see the tree in `fourpost check`"};
inline const Finding kTravelNotReached{
    "travel-not-reached", Severity::kWarning,
    "{} of axle '{}' goes from {} to {}, not from {} to {}; the linkage is at a dead "
    "centre there",
    "correct its points if the car travels further, else ask for less"};

}  // namespace fourpost
