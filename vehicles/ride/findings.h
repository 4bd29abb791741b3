#pragma once

#include "analysis/text/finding.h"

// What is found of a vehicle's modes.
namespace fourpost {

inline const Finding kUnstableInDesignPose{"unstable-in-design-pose", Severity::kWarning,
                                           "the vehicle is unstable in its design pose: {}", "see `fourpost check`"};
inline const Finding kModeGrows{"mode-grows", Severity::kWarning, "'{}' is unstable at {} = {}{}",
                                "check the signs of rates and dampers with `fourpost check`"};

}  // namespace fourpost
