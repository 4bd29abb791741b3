#pragma once

#include "analysis/text/finding.h"

// What can be wrong with methods of other libraries.
namespace fourpost {

inline const Finding kPeerUnknown{"peer-unknown", Severity::kError, "unknown method '{}'{}"};
inline const Finding kPeerTwice{"peer-twice", Severity::kError, "method '{}' is named twice", "remove one of the two"};
inline const Finding kPeerSettingUnknown{"peer-setting-unknown", Severity::kError,
                                         "method '{}': unknown setting '{}'{}"};
inline const Finding kPeerSettingOutOfRange{"peer-setting-out-of-range", Severity::kError,
                                            "method '{}': {} = {}, must be {} to {}"};
inline const Finding kScipyFailed{"scipy-failed", Severity::kError, "SciPy cannot be run: {}",
                                  "install python3-scipy, or leave the methods scipy_* out"};

}  // namespace fourpost
