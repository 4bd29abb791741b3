#pragma once

#include <optional>

#include <Eigen/Core>

#include "identify/refine/fit_variables.h"
#include "identify/search/archive.h"

namespace fourpost {

/// How many evaluations a column of a Jacobian takes: two, with an error of second order in the step, or one.
/// Automatic: the model supplies its derivatives itself, which counts as one; where it has none they are central ones.
enum class Differences { kCentral, kForward, kAutomatic };

/// The step at which an error of the residuals, `accuracy` of them, and the curvature that differences leave out weigh
/// alike: the cube root of the accuracy for central differences, the square root for forward ones.
double StepFor(double accuracy, Differences differences);

/// d residuals / d x by differences, N x n, all points in one parallel batch, or by the model. Steps of discrete axes
/// are at least one step of the lattice. Forward: the slope to x + step, or x - step at the upper bound. Central: each
/// column is the slope at x of the parabola through x and two more points: x +- step (central differences), or x + step
/// and x + 2 step on the inner side of a bound. Where one of the two fails, the other gives the slope alone.
/// `residuals` are those at x. Nothing when a column has no point that can be evaluated.
std::optional<Eigen::MatrixXd> DifferenceJacobian(Archive& archive, const FitVariables& variables,
                                                  const Eigen::VectorXd& x, const Eigen::VectorXd& residuals,
                                                  double step, Differences differences = Differences::kCentral);

}  // namespace fourpost
