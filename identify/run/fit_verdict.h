#pragma once

#include <string>
#include <vector>

#include "identify/fit/fit.h"
#include "identify/residuals/error_share.h"

namespace fourpost {

/// Whether a fit explains its data, however well its numbers converged.
struct FitVerdict {
  /// Why it does not; empty where nothing says so.
  std::vector<std::string> reasons;

  bool explains() const { return reasons.empty(); }
};

/// A model does not explain its data where, of what was fitted,
/// - a channel over all recordings, or a recording over all channels of one unit, has a normalised mean square error
///   above 100 %: a constant would be nearer. Only what is loud enough to judge, as a root mean square: over frequency
///   at least a tenth of the loudest of its unit, for next to a node small errors are large shares, over time 2 %;
/// - most parameters are at their bounds and the misfit is more than 1.5 times what noise and model error explain.
/// A fit that was interrupted is not judged: no reasons.
FitVerdict JudgeFit(const FitResult& fit, const std::vector<ErrorShare>& shares);

/// "this model does not explain these data: ..."; empty for one that does.
std::string VerdictText(const FitVerdict& verdict);

}  // namespace fourpost
