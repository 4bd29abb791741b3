#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <Eigen/Core>

namespace fourpost {

/// Additions that explain the residuals together, each less than it would alone.
struct JoinedAdditions {
  /// Places among those offered, in the order in which they were taken, and their shares: 1 is what each would be
  /// alone.
  std::vector<std::size_t> places;
  Eigen::VectorXd shares;
  /// By how much the criterion changes with each beside the others; below 0.
  std::vector<double> worth;
};

/// An addition that may be taken.
struct OfferedAddition {
  /// N weighted residuals that it leaves alone, the variables following.
  Eigen::VectorXd left;
  /// What it is an alternative for: of one thing one is taken.
  std::size_t thing = 0;
};

/// Stepwise selection: takes what lowers the criterion most for as long as it falls, at most six, and after each puts
/// alternatives in the place of others, or leaves these out, where the criterion falls by that: what came first may
/// have imitated what came after it. `before`: N weighted residuals. Shares lie within 0 and 2: what an
/// addition is beyond twice its size alone, its residuals to first order do not say. `change(squares before, left,
/// place)`: of the criterion.
JoinedAdditions JoinAdditions(const Eigen::VectorXd& before, const std::vector<OfferedAddition>& offered,
                              const std::function<double(double, const Eigen::VectorXd&, std::size_t)>& change);

}  // namespace fourpost
