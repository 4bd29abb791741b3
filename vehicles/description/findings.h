#pragma once

#include "analysis/text/finding.h"

// Why the posts of a vehicle cannot make a pattern.
namespace fourpost {

inline const Finding kPatternUnknown{"pattern-unknown", Severity::kError, "no pattern of posts is called '{}'{}"};
inline const Finding kPatternSides{"pattern-sides", Severity::kError,
                                   "the posts cannot make '{}', which needs posts at {} and {}",
                                   "give the share of each post instead"};
inline const Finding kPatternMiddle{"pattern-middle", Severity::kError,
                                    "the posts cannot make '{}', post '{}' is in the middle, neither {} nor {}",
                                    "give the share of each post instead"};
inline const Finding kPatternCorner{"pattern-corner", Severity::kError,
                                    "the posts cannot make '{}', which needs a post at each corner, and none is {} {}",
                                    "give the share of each post instead"};

}  // namespace fourpost
