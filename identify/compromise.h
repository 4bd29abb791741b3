#pragma once

#include <vector>

#include "identify/search/evaluation.h"

namespace fourpost {

/// The residuals of one output among those of a problem; the sum of their squares is its misfit J_k.
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
Problem CompromiseOf(Problem problem, std::vector<OutputResiduals> outputs);

}  // namespace fourpost
