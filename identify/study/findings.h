#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a study as a whole: its parameters, its search and its methods.
namespace fourpost {

// Problem and parameters.

inline const Finding kProblemUnknown{"problem-unknown", Severity::kError, "unknown problem '{}'{}"};
inline const Finding kStudyWithoutVehicle{"study-without-vehicle", Severity::kError,
                                          "this is a test problem for `fourpost compare`",
                                          "give a study with a vehicle and recordings"};
inline const Finding kStudyNotNames{"study-not-names", Severity::kError, "{} must be a list of names",
                                    "write it as [a, b]"};
inline const Finding kFreeNotNames{"free-not-names", Severity::kError,
                                   "'free' must be a list of names, `all`, or all parameters but some",
                                   "write [a, b] or `all but [a, b]`"};
inline const Finding kStartNotMapped{"start-not-mapped", Severity::kError, "'start' must map parameters to values",
                                     "write one line for each, as `k_front: 40 kN/m`"};
inline const Finding kFreeUnknown{"free-unknown", Severity::kError, "the vehicle has no parameter '{}'{}"};
inline const Finding kCalibrationUnknown{
    "calibration-unknown", Severity::kError,
    "'calibration' names '{}', which is neither a sensor of the vehicle nor a kind "
    "of instrument{}"};
inline const Finding kFreeWithoutRange{"free-without-range", Severity::kError,
                                       "parameter '{}' is to be fitted, but has no range",
                                       "give it lower, upper and precision"};
inline const Finding kFreeOutsideRange{"free-outside-range", Severity::kError,
                                       "parameter '{}' is to be fitted, but begins outside its range",
                                       "begin within it, or widen it in the vehicle file"};
inline const Finding kFreeTwice{"free-twice", Severity::kError, "parameter '{}' appears twice in 'free'",
                                "remove one of the two"};
inline const Finding kFreeMovesPoints{"free-moves-points", Severity::kError,
                                      "parameter '{}' moves points of the vehicle, and only `kinematics` follows them",
                                      "fit points to `kinematics` alone, then leave them out of `free`"};
inline const Finding kNothingFree{"nothing-free", Severity::kError,
                                  "no parameter has a range, so there is nothing to fit",
                                  "give at least one fp:parameter lower, upper and precision"};
inline const Finding kScaleNotMeasured{
    "scale-not-measured", Severity::kWarning,
    "no force or load is fitted, so masses, rates and damping constants are known up to a common factor, set by "
    "what is held fixed ({}); an error of 1 % there is an error of 1 % in all of them, {}",
    "fit a tyre force or `static_loads`, or measure what is held and state its 'prior_sd'", Weight::kGrave};

// The rig, by what its channels say of each other: what is wrong, what else would explain it, how sure it is.

inline const Finding kRigSign{"rig-sign", Severity::kError, "the sign is opposite: {}{} ({})", "write {} in the study",
                              Weight::kGrave};
inline const Finding kRigExchanged{"rig-exchanged", Severity::kError, "channels are exchanged: {}{} ({})",
                                   "exchange their names in the study", Weight::kGrave};
inline const Finding kRigUnit{"rig-unit", Severity::kError, "the unit is wrong: {}{} ({}); this is the ratio of {}",
                              "write {} in the study", Weight::kGrave};
inline const Finding kRigScale{"rig-scale", Severity::kWarning, "the other channels contradict a scale: {}{} ({})",
                               "check its calibration", Weight::kGrave};
inline const Finding kRigDelay{"rig-delay", Severity::kWarning, "the other channels contradict a time: {}{} ({})",
                               "write {} in the study", Weight::kGrave};
inline const Finding kRigPlace{"rig-place", Severity::kWarning, "the other channels contradict a position: {}{} ({})",
                               "measure it and correct the vehicle file", Weight::kGrave};
inline const Finding kRigPostsScale{"rig-posts-scale", Severity::kWarning,
                                    "the car does not follow its posts: {}{} ({}), or all else by the reciprocal",
                                    "check the transducer of the posts", Weight::kGrave};
inline const Finding kRigPostsDelay{"rig-posts-delay", Severity::kWarning,
                                    "the car does not follow its posts: {}{} ({}), or all else the other way",
                                    "check that posts and sensors are recorded by one clock", Weight::kGrave};
inline const Finding kRigClock{"rig-clock", Severity::kWarning,
                               "frequencies contradict forces and accelerations: {}{} ({})",
                               "check the frequencies, the load cells and the loads at rest", Weight::kGrave};
inline const Finding kRigLoads{"rig-loads", Severity::kWarning,
                               "loads at rest contradict forces and accelerations: {}{} ({})",
                               "check the tare and the scale of the load cells", Weight::kGrave};
inline const Finding kRigWheelpan{"rig-wheelpan", Severity::kWarning,
                                  "the other channels contradict a wheelpan: {}{} ({})",
                                  "weigh it and correct `wheelpan` at fp:sensor in the vehicle file", Weight::kGrave};
inline const Finding kRigForeign{"rig-foreign", Severity::kWarning, "the other channels agree without one: {}{} ({})",
                                 "check which channel it is, and whether it is dead or clipped", Weight::kGrave};
inline const Finding kRigContradiction{
    "rig-contradiction", Severity::kWarning,
    "channels contradict each other by {} times their noise, which no fault of wiring that is known explains",
    "check what each channel is and where it sits", Weight::kGrave};

// Refinement and methods.

inline const Finding kLossUnknown{"loss-unknown", Severity::kError, "unknown loss '{}'{}"};
inline const Finding kMethodsNotMapped{"methods-not-mapped", Severity::kError, "'methods' must map names to settings",
                                       "write them as `NAME: {preset: dvhde}`"};
inline const Finding kMethodNotSettings{"method-not-settings", Severity::kError, "{} must be a mapping of settings",
                                        "write one `setting: value` a line"};
inline const Finding kMethodPresetUnknown{"method-preset-unknown", Severity::kError, "unknown method '{}'{}"};
inline const Finding kMethodFormer{"method-former", Severity::kWarning, "'{}' is the earlier name of the method '{}'",
                                   "rename it", Weight::kSlight};
inline const Finding kSettingNotValue{"setting-not-a-value", Severity::kError, "'{}' of {} must be a single value",
                                      "write one word or one number"};
inline const Finding kSettingUnknown{"setting-unknown", Severity::kError, "method '{}': unknown setting '{}'{}"};
inline const Finding kSettingUnreadable{"setting-unreadable", Severity::kError, "method '{}': '{}' cannot be '{}'",
                                        "write a value of the kind that studies/README.md states"};
inline const Finding kSettingNotOneOf{"setting-not-one-of", Severity::kError, "method '{}': '{}' must be one of {}"};
inline const Finding kSettingOutOfRange{"setting-out-of-range", Severity::kError, "method '{}': {}"};
inline const Finding kMethodTwice{"method-twice", Severity::kError, "method '{}' is named twice",
                                  "remove one of the two"};
inline const Finding kMethodUnknown{"method-unknown", Severity::kError, "unknown method '{}'{}"};
inline const Finding kMethodOnlyRefines{
    "method-only-refines", Severity::kError,
    "'{}' refines random points, but a fit refines the points of its search by itself",
    "choose a method that explores, such as dvhde, thesis, de or direct"};

}  // namespace fourpost
