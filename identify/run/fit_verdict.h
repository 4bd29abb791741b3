#pragma once

#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/fit/fit.h"
#include "identify/residuals/error_share.h"
#include "identify/uncertainty/misfit_limits.h"

namespace fourpost {

/// Whether a fit explains its data, however well its numbers converged.
struct FitVerdict {
  /// Why it does not; empty where nothing speaks against it.
  Diagnostics reasons;
  /// What the check of the recordings would have refused, and the user accepted.
  Diagnostics accepted = {};

  bool explains() const { return reasons.items().empty(); }
};

/// A model does not explain its data where, of what was fitted,
/// - a channel over all recordings, or a recording over all channels of one unit, has a normalised mean square error
///   above 100 %: a constant would be nearer. Only what is loud enough to judge, as a root mean square: over frequency
///   at least a tenth of the loudest of its unit, for next to a node small errors are large shares, over time 2 %;
/// - the audit of the rig suspects a channel, which fit_run.cpp adds;
/// - implausible values were accepted, and the misfit is more than 1.5 times what noise and model error explain: a
///   channel in the wrong unit is either quiet beside the others of its unit, or has an NMSE just below 100 %;
/// - most parameters are at their bounds and the misfit is more than 1.5 times what noise and model error explain;
/// - more than a quarter of them is, the misfit is more than 3, and most channels have an error above 5 %;
/// - most channels have an error above 20 %, and the misfit is more than 1.5: what noise and the stated model error
///   allow is no fault of the model. Without a misfit that is not known.
/// Decibels and degrees are not counted: next to a node they are large in a good model. A fit that was interrupted is
/// not judged: no reasons.
FitVerdict JudgeFit(const FitResult& fit, const std::vector<ErrorShare>& shares, const Diagnostics& accepted = {});

/// What the fit and its standard deviations are worth: whether it explains the data and converged, and which parameters
/// they leave open. `has_deviations`: whether the cost weights by noise.
Diagnostics ConclusionsOf(const FitResult& fit, const FitVerdict& verdict, bool has_deviations);

}  // namespace fourpost
