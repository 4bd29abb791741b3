#pragma once

#include "analysis/text/finding.h"

// What is wrong with a file that a spring, a damper or a bushing takes its curves from.
namespace fourpost {

inline const Finding kCurveColumnMissing{
    "curve-column-missing", Severity::kError, "there is no column '{}'{}",
    "name the columns {}, with units; '-{}' or '-force' is one that counts the other way, positive in bump"};
inline const Finding kCurveColumnTwice{"curve-column-twice", Severity::kError, "column '{}' stands twice", "keep one"};
inline const Finding kCurveUnit{"curve-unit", Severity::kError, "column '{}' has {}, where a {} is needed",
                                "write it in the header, e.g. '{} [{}]'"};
inline const Finding kCurveNumber{"curve-number", Severity::kError, "'{}' is not a number, in column '{}'",
                                  "write digits, or remove the row"};
inline const Finding kCurvePoints{"curve-points", Severity::kError, "the curve has fewer than two points",
                                  "add points, in a row each"};
inline const Finding kCurveTooLong{"curve-too-long", Severity::kError, "the curve has {} points, more than {}",
                                   "take a point where the curve bends, not every sample of a recording"};
inline const Finding kCurveTooLarge{"curve-too-large", Severity::kError, "the point at {} has a force of {}",
                                    "check both and their units"};
inline const Finding kCurveOrder{
    "curve-order", Severity::kError, "the point at {}, {} does not lie above the point before it, {}, {}",
    "let {} and force rise from point to point, or both fall; of a recorded loop take the middle line"};
inline const Finding kCurvePushes{"curve-pushes", Severity::kError, "at {} the force is {}, which drives the motion",
                                  "give speed and force the same sign"};
inline const Finding kCurvePushesAlways{
    "curve-pushes-always", Severity::kError, "the force drives the motion at every speed",
    "extension and tension are positive: name the column '-force' or '-speed', or change its sign"};
inline const Finding kCurveAtRest{"curve-at-rest", Severity::kError, "at no speed the force is {}",
                                  "take that from all points, and state a gas force by <gas> of the damper"};
inline const Finding kCurveFileTooLarge{"curve-file-too-large", Severity::kError, "the file is larger than {}",
                                        "write the points of the curve alone, up to {} of them"};
inline const Finding kCurveXml{"curve-xml", Severity::kError, "a property file in XML, which is not read",
                               "save it in TeimOrbit format, or write its points as a table of text"};

// TeimOrbit, the format of Adams property files.

inline const Finding kTeimLine{
    "teim-line", Severity::kError, "'{}' is no line of a property file",
    "a line is [BLOCK], (SUBBLOCK), {NAMES OF COLUMNS}, NAME = VALUE, numbers, or $ and a comment"};
inline const Finding kTeimType{"teim-type", Severity::kError, "the file is of the type '{}', and {} needs one of '{}'",
                               "name another file"};
inline const Finding kTeimBlockMissing{"teim-block-missing", Severity::kError, "there is no block [{}]{}",
                                       "add it, or name a property file of {}"};
inline const Finding kTeimBlockTwice{"teim-block-twice", Severity::kError, "block [{}] stands in line {} already",
                                     "keep one of the two"};
inline const Finding kTeimValueMissing{"teim-value-missing", Severity::kError, "block [{}] has no {}",
                                       "add it, as in {} = {}"};
inline const Finding kTeimValue{"teim-value", Severity::kError, "{} = {} is not a number",
                                "write digits, e.g. {} = {}"};
inline const Finding kTeimUnit{"teim-unit", Severity::kError, "{} = '{}' is not a known unit", "write one of {}"};
inline const Finding kTeimRow{"teim-row", Severity::kError, "'{}' is not a row of two numbers",
                              "write {} and force, separated by blanks"};
inline const Finding kTeimFreeLength{"teim-free-length", Severity::kError,
                                     "FREE_LENGTH = {} is not a length above zero",
                                     "correct it, or remove it and give `at` in the vehicle file"};

inline const Finding kBushingCurveBent{
    "bushing-curve-bent", Severity::kWarning, "the rate of [{}] is {} at no displacement, and {} on average",
    "fp:bushing is linear and takes the first; where the bush works elsewhere, write that rate into the vehicle file"};
inline const Finding kBushingCurveZero{"bushing-curve-zero", Severity::kError,
                                       "the points of [{}] do not reach from below zero to above it",
                                       "add some on the other side, or write the rates into the vehicle file"};
inline const Finding kBushingRateTooLarge{"bushing-rate-too-large", Severity::kError,
                                          "the points of [{}] next to zero lie too close together for a rate",
                                          "correct them"};
inline const Finding kBushingDamping{"bushing-damping", Severity::kError, "{} = {} is below zero",
                                     "write a damping of zero or more"};

}  // namespace fourpost
