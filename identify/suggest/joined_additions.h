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
};

/// Forward selection: takes what lowers the squares most for as long as `pays` says so, at most six. `before`: N
/// weighted residuals; `with`: those that each addition leaves alone, the variables following. Shares lie within 0 and
/// 2: what an addition is beyond twice its size alone, its residuals to first order do not say. `pays(squares before,
/// left, place)`.
JoinedAdditions JoinAdditions(const Eigen::VectorXd& before, const std::vector<Eigen::VectorXd>& with,
                              const std::function<bool(double, const Eigen::VectorXd&, std::size_t)>& pays);

}  // namespace fourpost
