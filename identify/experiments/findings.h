#pragma once

#include "analysis/text/finding.h"

// What can be wrong with the files of a fit's folder.
namespace fourpost {

inline const Finding kFitColumnMissing{"fit-column-missing", Severity::kError, "no column '{}'", "fit again"};

}  // namespace fourpost
