#pragma once

#include "analysis/text/finding.h"

// What can be wrong with frequencies as a user writes them.
namespace fourpost {

inline const Finding kFrequencyUnreadable{"frequency-unreadable", Severity::kError, "'{}' is not a frequency",
                                          "write a number with its unit, such as 12 Hz"};
inline const Finding kFrequencyNotPositive{"frequency-not-positive", Severity::kError, "'{}' must be above zero"};
inline const Finding kFrequencyTwice{"frequency-twice", Severity::kError, "{} is listed twice",
                                     "remove one of the two"};
inline const Finding kFrequencyRangeMalformed{"frequency-range-malformed", Severity::kError, "'{}' is not a range",
                                              "write 0.5Hz:30Hz:40, or 0.5Hz:30Hz:0.5Hz for equal steps"};
inline const Finding kFrequencyRangeFalling{
    "frequency-range-falling", Severity::kError, "the range {} does not rise",
    "write the lower frequency first; `--direction down` sweeps from the upper one"};
inline const Finding kFrequencyCount{"frequency-count", Severity::kError, "{} is not a number of frequencies",
                                     "write a whole number from 2 to {}"};
inline const Finding kFrequencyStep{"frequency-step", Severity::kError, "steps of {} make {} frequencies",
                                    "choose a step that makes 2 to {}"};

}  // namespace fourpost
