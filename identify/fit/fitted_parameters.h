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

/// Widens the intervals of a fit by what its model lacks, see Certainty::AllowForMissing(); nothing where the fit has
/// none.
void AllowForMissing(const VehicleObjective& objective, std::vector<std::string> names, Eigen::MatrixXd moved,
                     FitResult& fit);

}  // namespace fourpost
