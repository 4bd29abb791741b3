#pragma once

#include <functional>

#include <Eigen/Core>

#include "identify/refine/refine.h"

namespace fourpost {

/// BFGS (Ceres) on the cost alone, for problems whose residuals say no more than it, with gradients by differences.
/// Bounds are met by x = middle + half_range sin(t) in FitVariables. Of the options, tolerances, iterations, step and
/// kind of differences count, no loss. `stop` is asked after each iteration. The result has no Jacobian.
/// Throws std::invalid_argument for a start out of bounds.
RefineResult MinimiseQuasiNewton(Archive& archive, const Eigen::VectorXd& start, const RefineOptions& options = {},
                                 const std::function<bool()>& stop = {});

}  // namespace fourpost
