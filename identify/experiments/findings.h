#pragma once

#include "analysis/text/finding.h"

// What can be wrong with recordings, whatever they are of, and with the files of a fit's folder.
namespace fourpost {

inline const Finding kChannelLength{"channel-length", Severity::kError, "column '{}' has {} samples, the times {}",
                                    "save channels of one rate together"};
inline const Finding kFitColumnMissing{"fit-column-missing", Severity::kError, "no column '{}'", "fit again"};

}  // namespace fourpost
