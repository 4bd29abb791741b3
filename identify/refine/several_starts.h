#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "identify/refine/refine.h"
#include "identify/search/archive.h"

namespace fourpost {

/// The outcome of refinements from several starts.
struct MultiStartResult {
  /// In the order of the starts.
  std::vector<RefineResult> runs;
  /// Run with the lowest cost; -1 when no start could be evaluated.
  int best = -1;
  /// Runs that ended by themselves.
  int ended = 0;
  /// Of these, runs that agree with the best in cost, itself included. Their values may still differ where the data do
  /// not determine them.
  int agreeing = 0;
};

/// Refines from each start in turn; the best wins. One that meets an earlier optimum ends there, with that one's
/// values. After `stop` the rest of the starts is left out. `coarse`: of the same variables, with cheaper residuals; a
/// refinement begins where theirs ends if that lowers the cost, and starts that reach one coarse optimum share one
/// refinement. Null: there are none.
MultiStartResult RefineFrom(Archive& archive, const std::vector<Eigen::VectorXd>& starts,
                            const RefineOptions& options = {}, const std::function<bool()>& stop = {},
                            Archive* coarse = nullptr);

}  // namespace fourpost
