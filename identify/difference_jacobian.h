#pragma once

#include <optional>

#include <Eigen/Core>

#include "identify/archive.h"
#include "identify/fit_variables.h"

namespace fourpost {

/// d residuals / d x by differences, N x n, all points in one parallel batch of 2n evaluations. Each column is the
/// slope at x of the parabola through x and two more points: x +- step (central differences), or x + step and x + 2
/// step on the inner side of a bound. Where one of the two fails, the other gives the slope alone. `residuals` are
/// those at x. Nothing when a column has no point that can be evaluated.
std::optional<Eigen::MatrixXd> DifferenceJacobian(Archive& archive, const FitVariables& variables,
                                                  const Eigen::VectorXd& x, const Eigen::VectorXd& residuals,
                                                  double step);

}  // namespace fourpost
