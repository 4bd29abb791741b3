#pragma once

#include <functional>
#include <optional>

#include <Eigen/Core>

#include "identify/suggest/score_test.h"

namespace fourpost {

/// The k numbers of an addition as variables within bounds, see FitVariables.
struct NewNumbers {
  Eigen::VectorXd first;
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
  /// Residuals with these numbers and a step of the n variables of the fitted point; nothing where they cannot be
  /// evaluated.
  std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd& numbers, const Eigen::VectorXd& step)> residuals;
};

/// Goes on where Confirm() ended: steps of Gauss and Newton in all numbers and the variables together, each evaluated
/// truly and kept where the cost falls. Derivatives by the numbers are differences at each point, those by the
/// variables stay as they were. Returns the numbers where the test then ends.
Eigen::VectorXd FitNumbers(const FollowedCost& fitted, const NewNumbers& numbers, ScoreTest& test);

}  // namespace fourpost
