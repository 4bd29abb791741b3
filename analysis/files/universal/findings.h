#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a universal file.
namespace fourpost {

inline const Finding kUniversalBlock{"uff-block", Severity::kError, "'{}' is not the number of a data set",
                                     "export the universal file again"};
inline const Finding kUniversalField{"uff-field", Severity::kError,
                                     "record {} of data set 58: {} is '{}', not a number{}",
                                     "export the universal file again"};
inline const Finding kUniversalEnds{"uff-ends", Severity::kError, "the file ends within a data set {}",
                                    "copy or export it again"};
inline const Finding kUniversalValues{"uff-values", Severity::kError, "data set 58 has {} numbers and needs {}",
                                      "copy or export it again"};
inline const Finding kUniversalFloats{"uff-floats", Severity::kError, "data set 58b stores numbers as {}",
                                      "export it with IEEE 754 numbers, or as ASCII"};
inline const Finding kUniversalBytes{"uff-bytes", Severity::kError,
                                     "data set 58b has {} bytes of numbers at byte {} and needs {}",
                                     "copy or export it again"};
inline const Finding kUniversalNothing{"uff-nothing", Severity::kError,
                                       "universal file without time histories and frequency responses (data sets {})",
                                       "export data set 58 with functions of type 1 or 4"};

}  // namespace fourpost
