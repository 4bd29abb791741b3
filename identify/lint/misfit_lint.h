#pragma once

#include "analysis/diagnostics.h"
#include "identify/fit.h"
#include "identify/loaded_study.h"

namespace fourpost {

/// What a fit leaves that noise and the stated model error can hardly explain, as warnings with the likely causes: of
/// static loads, see LintLoads, and one for all channels of stepped sines that are off by more than four times that, as
/// a root mean square over the band.
void LintMisfits(const LoadedStudy& study, const FitResult& fit, Diagnostics& diagnostics);

}  // namespace fourpost
