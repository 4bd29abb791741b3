#pragma once

#include "analysis/text/finding.h"

// What can be wrong with loads under the tyres at rest, before and after a fit.
namespace fourpost {

inline const Finding kStaticLoadTyreUnknown{"static-load-tyre-unknown", Severity::kError,
                                            "the vehicle has no tyre '{}'{}"};
inline const Finding kStaticLoadMissing{"static-load-missing", Severity::kError, "{} has no force '{}'{}",
                                        "correct the name, or add a row of this name"};
inline const Finding kStaticLoadNotPositive{"static-load-not-positive", Severity::kError,
                                            "a static load presses on the post and must be above zero",
                                            "check its value, and 'sign' in the study"};
inline const Finding kStaticLoadWithoutDeviation{"static-load-without-deviation", Severity::kError,
                                                 "a static load needs a standard deviation above zero to be weighted",
                                                 "write one into the column 'sd'"};

// Before the fit.

inline const Finding kStaticLoadsAboveBounds{
    "loads-above-bounds", Severity::kWarning,
    "the static loads add up to {} kN, the vehicle with all masses at their upper bounds to {} kN, {} kg less",
    "check whether the load cells were tared, whether wheelpans or a payload were weighed too, and the bounds of the "
    "masses"};
inline const Finding kStaticLoadsBelowBounds{
    "loads-below-bounds", Severity::kWarning,
    "the static loads add up to {} kN, the vehicle with all masses at their lower bounds to {} kN, {} kg more",
    "check whether corners or axles are left out, and the bounds of the masses"};

// After the fit.

inline const Finding kStaticLoadsHeavierThanMotion{
    "loads-heavier-than-motion", Severity::kWarning,
    "the static loads add up to {} kg, the dynamic forces alone to {} kg (standard deviation {} kg, the model's error "
    "included); between {} and {} kg in all are weighed too or not tared on the {} loads, such as wheelpans",
    "{}weigh one or look it up, and subtract its mass there; or check the scale of the load cells in motion"};
inline const Finding kStaticLoadsLighterThanMotion{
    "loads-lighter-than-motion", Severity::kWarning,
    "the static loads add up to {} kg, the dynamic forces alone to {} kg (standard deviation {} kg, the model's error "
    "included); between {} and {} kg in all are missing on the {} loads",
    "{}add what was not weighed, or check the scale of the load cells in motion"};
inline const Finding kStaticLoadFarOff{"load-far-off", Severity::kWarning, "the fitted loads at rest are far off: {}",
                                       "{}check for a load cell not tared, for a wheelpan or payload weighed too, for "
                                       "bounds that exclude the solution{}, and for a standard deviation that is too "
                                       "small"};
inline const Finding kStaticLoadsDiffer{
    "static-loads-differ", Severity::kWarning,
    "measured loads at rest differ from the fitted ones by more than 3 standard deviations: {}",
    "{}check the scale of the cells (all differ alike), free the centre of mass (one side or axle does) or level the "
    "posts "
    "(one diagonal does: cross weight)"};

}  // namespace fourpost
