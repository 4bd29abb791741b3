#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/fit/fit.h"

namespace fourpost {

/// The free parameters at `values` (SI), and what is known of them; deviations are NaN without a certainty.
std::vector<FittedParameter> DescribeParameters(const VehicleObjective& objective, const Lattice& lattice,
                                                const Eigen::VectorXd& values,
                                                const std::optional<Certainty>& certainty);

/// What a model lacks by its own residuals.
struct MissingPhysics {
  std::vector<std::string> names;
  /// See Certainty::by_missing.
  Eigen::MatrixXd moved;
  /// What is left with it, priors included, and the derivatives at the fitted values, N x n in FitVariables.
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
};

/// Lets the intervals of a fit reach from its values to where they would be with what is missing, see
/// Certainty::AllowForMissing(). Leaves a fit without intervals as it is, or where nothing is missing.
void AllowForMissing(const VehicleObjective& objective, MissingPhysics missing, FitResult& fit);

}  // namespace fourpost
