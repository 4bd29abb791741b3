#pragma once

#include "analysis/text/finding.h"

// What is wrong with a request of a vehicle, and what its answer needs a word about.
namespace fourpost {

// Values of options.

inline const Finding kOptionQuantity{"option-quantity", Severity::kError, "'{}' is not a {}{}",
                                     "write a number with its unit, such as {}"};
inline const Finding kOptionNotPositive{"option-not-positive", Severity::kError, "'{}' must be above zero"};
inline const Finding kOptionShare{"option-share", Severity::kError, "'{}' is not a share",
                                  "write it in percent, such as 1%"};
inline const Finding kOptionShareAbove{"option-share-above-one", Severity::kError, "'{}' must not be above 100%"};
inline const Finding kOptionFrequencyRange{"option-frequency-range", Severity::kError,
                                           "'{}' is not a range of frequencies",
                                           "write first:last, such as 0.5Hz:30Hz"};
inline const Finding kOptionRangeFalling{"option-range-falling", Severity::kError, "the range '{}' does not rise",
                                         "write its lower end first"};
inline const Finding kOptionTravel{"option-travel", Severity::kError,
                                   "the travel '{}' does not contain the design pose",
                                   "write one length for both ways, such as 80mm, or rebound:bump, such as -60mm:80mm"};
inline const Finding kOptionTravelSteps{"option-travel-steps", Severity::kError,
                                        "steps of '{}' divide the travel into more than {}", "give a longer one"};
inline const Finding kOptionSensor{"option-sensor", Severity::kError, "the vehicle has no sensor '{}'{}"};
inline const Finding kOptionParameter{"option-parameter", Severity::kError, "the vehicle has no parameter '{}'{}"};
inline const Finding kOptionParameterTwice{"option-parameter-twice", Severity::kError, "'{}' is given twice",
                                           "remove one of the two"};
inline const Finding kSettingIncomplete{"setting-incomplete", Severity::kError, "'{}' sets nothing",
                                        "write name=value with its unit"};
inline const Finding kSettingUnit{"setting-unit", Severity::kError, "'{}={}' needs a unit or has a wrong one",
                                  "write for instance {}"};
inline const Finding kSettingNotANumber{"setting-not-a-number", Severity::kError, "'{}={}' must be a plain number",
                                        "leave out the unit"};
inline const Finding kSettingSign{"setting-sign", Severity::kError,
                                  "'{}' = {} must be {} zero, as in the vehicle file"};
inline const Finding kSettingOutOfBounds{"setting-out-of-bounds", Severity::kWarning,
                                         "'{}' = {} is outside its bounds {} .. {}",
                                         "check it, or widen the bounds in the vehicle file"};
inline const Finding kRangeUnbounded{"range-unbounded", Severity::kError, "'{}' has no bounds",
                                     "give the range, as in {}"};
inline const Finding kRangeMalformed{"range-malformed", Severity::kError, "'{}' is not a range",
                                     "write first:last:count, such as 20kN/m:80kN/m:13, with 2 to 1000 values"};
inline const Finding kRangeEmpty{"range-empty", Severity::kError, "the range '{}' begins where it ends",
                                 "give two different ends"};

// Motion of the posts.

inline const Finding kSensorNone{"sensor-none", Severity::kError,
                                 "the vehicle has no fp:sensor, so it has no response to compute", "add one"};
inline const Finding kPostNone{"post-none", Severity::kError, "the vehicle has no fp:post to move",
                               "add one under each tyre"};
inline const Finding kShareNoReference{"share-no-reference", Severity::kError, "'{}' has no reference post",
                                       "give one post the share 1 or -1"};
inline const Finding kSharePost{"share-post", Severity::kError, "the vehicle has no post '{}'{}"};
inline const Finding kShareMalformed{"share-malformed", Severity::kError, "'{}' is not a share of a post",
                                     "write {}=1, or -1 against it"};
inline const Finding kSharePostTwice{"share-post-twice", Severity::kError, "post '{}' is given twice",
                                     "remove one of the two"};
inline const Finding kModeUnknown{"mode-unknown", Severity::kError, "no pattern of posts is called '{}'{}",
                                  "write heave (bounce), pitch, roll, warp or the share of each post, such as {}=1"};
inline const Finding kLimitOpen{
    "limit-open", Severity::kWarning,
    "not given, and its usual {} does not apply when another limit is given, so the post reaches {}",
    "give this limit as well if the rig has it"};
inline const Finding kBodiesBend{"bodies-bend", Severity::kWarning,
                                 "above {} the bodies of a road vehicle bend, but those of the model are rigid",
                                 "do not compare the response up there with a car's"};

// Answers.

inline const Finding kUnstable{"unstable", Severity::kError,
                               "the vehicle is unstable in its design pose, so it has no steady response ({})",
                               "see `fourpost check`"};
inline const Finding kEngineRefused{"engine-refused", Severity::kError, "cannot be used here ({})",
                                    "use `--engine auto`"};
inline const Finding kIntegratedHysteresis{
    "integrated-hysteresis", Severity::kWarning,
    "friction in series with a spring sticks and slides within a cycle, so the response was integrated in time{}"};
inline const Finding kBalanceUnconverged{
    "balance-unconverged", Severity::kWarning,
    "the {} harmonic balance did not converge at {} of {} frequencies, {}, which were integrated in time from rest",
    "look there for wheels that leave the ground and stops that are hit; a smaller amplitude avoids them"};
inline const Finding kBalanceInterrupted{
    "balance-interrupted", Severity::kWarning,
    "the {} harmonic balance did not converge at {} of {} frequencies, {}, and their time integration was interrupted",
    "run it again and let it end"};
inline const Finding kOtherMotion{
    "other-motion", Severity::kWarning,
    "from rest the vehicle settles to another motion at {} ('{}' at {} differs by {}), so the reported one is unstable "
    "or one of several",
    "compare --engine time or `fourpost simulate`"};

}  // namespace fourpost
