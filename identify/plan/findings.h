#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a file that says what a rig can measure, and what a plan needs a word about.
namespace fourpost {

inline const Finding kRigRunsNone{"rig-runs-none", Severity::kError, "'runs' must be a list of runs",
                                  "write lines such as `- {mode: heave, band: [0.5 Hz, 30 Hz], amplitude: 8 mm}`"};
inline const Finding kRigRunMode{"rig-run-mode", Severity::kError,
                                 "{} is '{}', in which the posts of this vehicle cannot move",
                                 "write heave, pitch, roll, warp, or the shares of posts as in `{}=1`"};
inline const Finding kRigRunTwice{"rig-run-twice", Severity::kError, "'{}' is there twice",
                                  "give one of them another `name`, or remove it"};
inline const Finding kRigMeasurementParameter{"rig-measurement-parameter", Severity::kError,
                                              "the plan has no parameter '{}' to measure{}"};
inline const Finding kRigListNone{"rig-list-none", Severity::kError, "{} must be a list with at least one entry",
                                  "write `[{}]`"};
inline const Finding kRigNoiseNone{"rig-noise-none", Severity::kError, "{} must be above zero",
                                   "state by how much amplitudes differ from repeat to repeat, or leave it out"};
inline const Finding kRigQuantity{"rig-quantity", Severity::kError,
                                  "{} must be a number above zero with a unit such as {}, or a share in percent",
                                  "write it as in `2 %`"};
inline const Finding kRigSensor{"rig-sensor", Severity::kError, "the vehicle has no sensor '{}'{}"};
inline const Finding kRigWanted{"rig-wanted", Severity::kError, "'want' names '{}', which is not determined here{}"};

inline const Finding kPlanWithoutPosts{"plan-without-posts", Severity::kError,
                                       "the vehicle has no fp:post, or no sensor that a rig could read",
                                       "add a post under each tyre and the sensors of the rig", Weight::kGrave};
inline const Finding kPlanWithoutParameters{"plan-without-parameters", Severity::kError,
                                            "there is no parameter to determine",
                                            "give parameters a range, or name the folder of a fit"};
inline const Finding kPlanLeftOut{"plan-left-out", Severity::kWarning,
                                  "{} have no standard deviation in the fit, and the plan leaves them as they are",
                                  "fit again with wider bounds, or plan for its vehicle.urdf, by their ranges"};
inline const Finding kPlanNothingAffordable{"plan-nothing-affordable", Severity::kError,
                                            "no run takes less than {}, the time that there is",
                                            "allow more time, or give runs fewer frequencies or a narrower band"};
inline const Finding kPlanRunWithoutMotion{"plan-run-without-motion", Severity::kWarning, "'{}' is left out: {}",
                                           "choose smaller amplitudes or a narrower band"};
inline const Finding kPlanNoiseAssumed{
    "plan-noise-assumed", Severity::kWarning,
    "no noise is stated or recorded of {}; 1 % of each channel's largest amplitude is assumed",
    "state under 'noise' by how much amplitudes differ from repeat to repeat"};
inline const Finding kPlanWantMissed{"plan-want-missed", Severity::kWarning,
                                     "{} is not known as well as wanted after {}: the plan reaches {}",
                                     "allow more time, more repeats, or other runs and measurements", Weight::kGrave};

}  // namespace fourpost
