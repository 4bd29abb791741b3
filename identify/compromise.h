#pragma once

#include <vector>

#include "identify/search/evaluation.h"

namespace fourpost {

/// The residuals of one output among those of a problem; the sum of their squares is its misfit J_k. That is the
/// thesis's mean square error in percent (4.28) where residuals are errors times 10 / (sqrt(N) s), s: the output's
/// deviation, N: its samples; where they are over another deviation, the weight makes it so.
struct OutputResiduals {
  Eigen::Index first = 0;
  Eigen::Index count = 0;
  /// w_k.
  double weight = 1;
};

/// The compromise cost of the thesis (4.29, with the aims J*_k = 0): outputs are weighed by their own misfits,
///   J^2 = sum over outputs of (w_k J_k)^2,   J_k = |r_k|^2,
/// so that no output is given up for the others. As residuals w_k |r_k| r_k, whose squares add up to J^2, which
/// refines as fast as any least squares; residuals of no output are left out. A failure of the problem is one of this.
/// Throws std::invalid_argument for outputs that reach beyond the problem's residuals, or whose weight is not positive.
Problem CompromiseOf(const Problem& problem, const std::vector<OutputResiduals>& outputs);

}  // namespace fourpost
