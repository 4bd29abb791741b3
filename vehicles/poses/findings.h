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
    "'{}' of axle '{}' goes from {} to {}, not from {} to {}; the linkage is at a dead centre there",
    "correct its points if the car travels further, else ask for less"};
inline const Finding kTravelNotHeld{
    "travel-not-held", Severity::kWarning,
    "'{}' of axle '{}' goes from {} to {}, not from {} to {}; beyond there springs, bushings and stops hold no pose at "
    "rest",
    "check their rates and the points of the linkage if the car travels further, else ask for less"};

inline const Finding kDoesNotSettle{"does-not-settle", Severity::kError, "found no pose at rest",
                                    "run `fourpost check`, which names motions that nothing holds, and check preloads, "
                                    "free lengths and rates"};
inline const Finding kSettledUnevenly{"settled-unevenly", Severity::kError,
                                      "{} and its mirror partner settle differently, which fp:mirror cannot hold",
                                      "write both sides out"};
inline const Finding kDesignPoseNotHeld{"design-pose-not-held", Severity::kError,
                                        "no force or length of {} holds the design pose",
                                        "run `fourpost check`, which names motions that nothing holds"};
inline const Finding kSettledAtOneValue{
    "settled-at-one-value", Severity::kWarning,
    "the file written is at rest at its parameters' values only, and a fit or `check` needs rest within their bounds",
    "pass --equilibrium, which leaves the springs' preloads to equilibrium, or remove the bounds"};
inline const Finding kSettledFileMoves{"settled-file-moves", Severity::kError,
                                       "the file at rest is not at rest as its text states it",
                                       "keep the design pose by --hold"};
inline const Finding kLawCountsFromDesign{
    "law-counts-from-design", Severity::kError,
    "{} is {} from its design pose at rest, and its law counts from there in a way that a file at rest cannot state",
    "state it for the pose at rest by hand, or hold the design pose with the preloads shown"};

}  // namespace fourpost
