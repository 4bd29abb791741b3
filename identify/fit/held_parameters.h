#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "identify/refine/refine.h"
#include "identify/residuals/vehicle_objective.h"

namespace fourpost {

/// Parameters that a fit holds although their ranges say that they are not exactly known.
struct HeldParameters {
  /// Places in Vehicle::parameters.
  std::vector<std::size_t> places;
  /// In FitVariables: of the prior, else of the range, uniform over it.
  Eigen::VectorXd variable_sd;
  /// d residuals / d FitVariables of them, N x held; priors of the free ones included.
  Eigen::MatrixXd jacobian;
  /// Places of those outside their ranges, and of those that the model has no derivative by: in none of the above.
  std::vector<std::size_t> left_out;
};

/// Of the parameters that are not free but have a range, at these values of the free ones; adds evaluations to
/// `evaluated`. `left_out` is empty where the user stops it.
HeldParameters HeldAt(const VehicleObjective& objective, const Eigen::VectorXd& values, const RefineOptions& refine,
                      int threads, const std::function<bool()>& stop, std::int64_t& evaluated);

}  // namespace fourpost
