#pragma once

#include "analysis/text/finding.h"

// What a vehicle file says that is likely meant otherwise. Most begin with the name of an element, "fp:spring 'coil'".
namespace fourpost {

// Numbers.

inline const Finding kNumberUnusual{"number-unusual", Severity::kWarning, "{} of {} is {}, {}", "was {} meant?"};
inline const Finding kNumberFarOff{"number-far-off", Severity::kWarning, "{} of {} is {}, {}",
                                   "check its digits and its unit"};
inline const Finding kMeanRateUnusual{"mean-rate-unusual", Severity::kWarning, "mean rate of {} up to {} is {}, {}",
                                      "was {} meant?"};
inline const Finding kMeanRateFarOff{"mean-rate-far-off", Severity::kWarning, "mean rate of {} up to {} is {}, {}",
                                     "check its digits and its unit"};
inline const Finding kCubicDominates{"cubic-dominates", Severity::kWarning,
                                     "cubic of {} makes {} at {}, its stiffness only {}",
                                     "check its digits and its unit"};
inline const Finding kPlaceInMillimetres{"place-in-millimetres", Severity::kWarning,
                                         "{} is {} from the origin of its axes", "was {} meant? xyz is in metres"};
inline const Finding kStopWithoutGap{"stop-without-gap", Severity::kWarning,
                                     "{} has no gap on either side, so it acts as a spring",
                                     "give its gaps, or make it a spring"};
inline const Finding kGapBeyondLength{"gap-beyond-length", Severity::kWarning,
                                      "{} is {} long in the design pose, so it is never compressed by {}",
                                      "correct its ends, its gap or its knee"};
inline const Finding kOilColumnShort{"oil-column-short", Severity::kWarning,
                                     "the {} column of {} is {} long, but {} begins after {}, so the piston meets the "
                                     "end before the stop",
                                     "correct one of them"};
inline const Finding kDampingSwapped{"damping-swapped", Severity::kWarning,
                                     "{} resists bump with {} and rebound with {}{}",
                                     "swap the two rates if they are "
                                     "the wrong way round"};
inline const Finding kTableAtRest{
    "table-at-rest", Severity::kWarning,
    "the points of {} beside rest give {} there, but a damper has no force at rest, so its curve bends through zero",
    "take away what is there at rest, such as a gas force,{} or add <point speed=\"0 m/s\" force=\"0 N\"/>"};
inline const Finding kTableNotPlaced{
    "table-not-placed", Severity::kWarning,
    "{} stands at the zero of its table, but carries {} at rest, which the table gives elsewhere",
    "state where on the table it stands in the design pose by at=\"...\"{}, or at=\"0 m\" if its forces count from "
    "there"};
inline const Finding kTyreTableEnd{
    "tyre-table-end", Severity::kWarning,
    "{} carries {} at rest, beyond the table, which holds {} to {}, so its curve is extrapolated linearly",
    "measure its deflection up to twice the load at rest and from near zero, or correct the masses or the preload"};
inline const Finding kParameterIdle{"parameter-idle", Severity::kWarning,
                                    "fp:parameter '{}' changes no motion, no static load and no sensor's reading",
                                    "remove it, or what keeps its element from moving"};

// Places.

inline const Finding kSensorOffBody{"sensor-off-body", Severity::kWarning,
                                    "{} is {} off everything that the file shows of link '{}', which carries it",
                                    "correct the link, or xyz, which is in metres and in the axes of its link"};
inline const Finding kInertiaUnusual{
    "inertia-unusual", Severity::kWarning,
    "inertia of {} is {} at a mass of {}, a radius of gyration of {} beyond everything that the file shows of the body",
    "check the digits and units of both"};
inline const Finding kTyreRadiusOff{
    "tyre-radius-off", Severity::kWarning,
    "the point of {} is {} above the platform, z = 0, in the design pose, but its radius is {}",
    "correct the joint's origin, the point or the radius"};
inline const Finding kTyreHeight{"tyre-height", Severity::kWarning,
                                 "the point of {} is {} above the platform, z = 0, in the design pose",
                                 "correct the joint's origin or the point"};
inline const Finding kLineShort{"line-short", Severity::kWarning,
                                "{} is {} long in the design pose, so its direction turns with the least motion",
                                "correct its ends, or give it an axis"};
inline const Finding kLineLong{"line-long", Severity::kWarning, "{} is {} long in the design pose", "correct its ends"};
inline const Finding kPostsNone{"posts-none", Severity::kWarning,
                                "the vehicle has tyres but no post, so nothing can move it",
                                "add an fp:post under each tyre"};
inline const Finding kPostMissing{"post-missing", Severity::kWarning, "{} has no post while others have one",
                                  "add an fp:post under it"};
inline const Finding kSensorsNone{"sensors-none", Severity::kWarning,
                                  "the vehicle has no sensor, so nothing of its response is seen",
                                  "add fp:sensor tags; a study with `bench` needs none"};

// Symmetry.

inline const Finding kMirrorNumber{"mirror-number", Severity::kWarning, "{} of {} is {}, that of {} (line {}) {}",
                                   "correct one of them{}"};
inline const Finding kMirrorPoint{"mirror-point", Severity::kWarning,
                                  "{} of {} is {} off the mirror image of that of {} (line {}) in the design pose",
                                  "correct one, or use fp:mirror"};
inline const Finding kBarSide{"bar-side", Severity::kWarning, "both lines of {} are on the {} of the car",
                              "give one the points of the other side"};

// The vehicle at rest and in motion.

inline const Finding kClosureOpen{"closure-open", Severity::kWarning,
                                  "the two points of {} are {} apart as written; closing the loops moves {}",
                                  "correct the points or the joints between them"};
inline const Finding kTyrePullsAtRest{"tyre-pulls-at-rest", Severity::kWarning,
                                      "{} pulls on its platform with {} at rest",
                                      "check where the masses are and which preloads are given"};
inline const Finding kSpringPulled{"spring-pulled", Severity::kWarning,
                                   "{} is pulled with {} at rest, which a coil does not bear", "check its ends{}"};
inline const Finding kWeightElsewhere{"weight-elsewhere", Severity::kWarning,
                                      "the tyres carry {} at rest, but the vehicle weighs {}; the rest is on {}",
                                      "free that, or read the loads as those of a guided vehicle"};
inline const Finding kMotionFree{"motion-free", Severity::kWarning, "nothing resists {}",
                                 "add a spring or a bushing, or take a joint without this freedom"};
inline const Finding kMotionFreeAlong{"motion-free-along", Severity::kWarning, "nothing resists {}",
                                      "give the tyres a longitudinal stiffness"};
inline const Finding kMotionFreeAcross{"motion-free-across", Severity::kWarning, "nothing resists {}",
                                       "give the tyres a lateral stiffness"};
inline const Finding kSensorBlind{"sensor-blind", Severity::kWarning, "{} reads nothing, however the vehicle moves",
                                  "correct what carries it, or its axis"};
inline const Finding kModeUndamped{
    "mode-undamped", Severity::kWarning,
    "mode '{}' at {} has a damping ratio of {}, lower than any measured car's, so time integration barely settles",
    "add an fp:damper, or damping to a bushing or tyre"};
inline const Finding kModeUndampedByTyres{
    "mode-undamped-by-tyres", Severity::kWarning,
    "mode '{}' at {} has a damping ratio of {}, lower than any measured car's, so time integration barely settles",
    "give the tyres {}"};
inline const Finding kVehicleUnstable{"vehicle-unstable", Severity::kWarning,
                                      "the vehicle is unstable in its design pose ({})",
                                      "add the rod or spring that holds it, or correct positions, axes or rates"};
inline const Finding kWheelRateNegative{"wheel-rate-negative", Severity::kWarning,
                                        "the wheel rate at fp:tyre '{}' is {}, below zero",
                                        "check the points of its links, rods and springs, and its own"};
inline const Finding kWheelRateHigh{"wheel-rate-high", Severity::kWarning,
                                    "the wheel rate at fp:tyre '{}' is {}, above the tyre's",
                                    "check the points of its links, rods and springs, and its own"};
inline const Finding kMotionRatio{"motion-ratio", Severity::kWarning, "{} has a motion ratio of {} to its wheel",
                                  "check its ends{}"};

}  // namespace fourpost
