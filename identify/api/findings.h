#pragma once

#include "analysis/text/finding.h"

// What can be wrong with what a program asks of the library.
namespace fourpost {

inline const Finding kNameUnknown{"name-unknown", Severity::kError, "there is no {} '{}'{}"};
inline const Finding kQuantityWrong{"quantity-unreadable", Severity::kError,
                                    "'{}' is not a number with a unit of the dimension of {}",
                                    "write both, such as \"40 kN/m\""};
inline const Finding kUnitUnknown{"unit-unknown", Severity::kError, "'{}' is not a unit{}",
                                  "write N/m, kN*s/m, mm and the like"};
inline const Finding kAmplitudeCount{"amplitude-count", Severity::kError, "there are {} amplitudes for {} frequencies",
                                     "give one for each, or one for all"};
inline const Finding kArrayNegative{"array-negative", Severity::kError, "{} holds a negative number",
                                    "give standard deviations, which are zero or more"};
inline const Finding kArraysUnequal{"arrays-unequal", Severity::kError, "{} has {} values, but {} are needed",
                                    "give all arrays of a test the same length"};
inline const Finding kRateNotPositive{"rate-not-positive", Severity::kError, "the sampling rate is {} Hz",
                                      "give that of the arrays, above zero"};
inline const Finding kArgumentRefused{"argument-refused", Severity::kError, "{}", "correct the value"};
inline const Finding kNumberNotFinite{"number-not-finite", Severity::kError, "{} holds a number that is not finite",
                                      "leave such samples out"};
inline const Finding kTableShape{"table-shape", Severity::kError, "{} columns of values, but {} parameters",
                                 "give a row for each car and a column for each parameter"};
inline const Finding kValueOutOfRange{"value-out-of-range", Severity::kError, "derivatives need values in range ({})",
                                      "correct the value, or the range in the vehicle file"};
inline const Finding kEvaluationFailed{"evaluation-failed", Severity::kError,
                                       "the model cannot be evaluated at these values ({})", "try others"};
inline const Finding kCallStopped{"call-stopped", Severity::kError, "stopped before its end", "call it again"};
inline const Finding kEngineOfSines{"engine-of-sines", Severity::kError,
                                    "engine kTimeIntegration is for stepped sines, not for time histories",
                                    "take kFull"};
inline const Finding kStudyEmpty{"study-empty", Severity::kError, "the study has no experiment to fit", "add one"};
inline const Finding kStudyOfFile{"study-of-file", Severity::kError, "the study {} is a file, which decides its {}",
                                  "change the file, or build the study from arrays"};
inline const Finding kSearchAxes{"search-axes", Severity::kError, "the axes span no grid ({})", "correct the axis"};
inline const Finding kSearchMethod{"search-method", Severity::kError, "there is no method '{}'{}",
                                   "write one of those of `fourpost compare --help`"};
inline const Finding kSearchAllFailed{"search-all-failed", Severity::kError, "every evaluation failed ({})",
                                      "check the residuals and the bounds"};

}  // namespace fourpost
