#pragma once

#include "analysis/diagnostics.h"
#include "identify/fit.h"
#include "identify/loaded_study.h"

namespace fourpost {

/// What a fit leaves that noise and the stated model error can hardly explain, as one warning for all static loads, and
/// one for all channels of stepped sines, with the likely causes: loads that are off by more than four standard
/// deviations, and channels that are by their root mean square over the band.
void LintMisfits(const LoadedStudy& study, const FitResult& fit, Diagnostics& diagnostics);

}  // namespace fourpost
