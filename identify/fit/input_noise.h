#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include <Eigen/Core>

#include "identify/refine/refine.h"
#include "identify/residuals/vehicle_objective.h"

namespace fourpost {

/// What noise of recorded inputs does to a fit. It passes through the model like motion, is correlated with the
/// derivatives, and so moves the optimum however long the record is (errors in variables). Noise of the same size is
/// added once more, with both signs, and the gradient moves by as much again (simulation extrapolation: Cook and
/// Stefanski, J. Am. Stat. Assoc. 89, 1994); the part that is linear in the noise cancels.
struct InputNoise {
  /// Of the data, N x n in FitVariables: what the inputs' noise adds to the gradient, residual by residual.
  Eigen::MatrixXd gradient;
  /// The same by the objective's calibrations, N x calibrations; empty without any, or where it cannot be evaluated.
  Eigen::MatrixXd of_calibrations;
  /// n: the step that takes it from the optimum; zero for those that stay.
  Eigen::VectorXd step;
  /// Of the data: what it adds to the sum of squared residuals.
  double squares = 0;
};

/// Nothing where no input is known to have noise, an evaluation fails, or the user stops it. `held`: places of
/// parameters that stay. Evaluations are added to `evaluated`.
std::optional<InputNoise> InputNoiseAt(const VehicleObjective& objective, const RefineResult& best,
                                       const RefineOptions& refine, const std::vector<Eigen::Index>& held, int threads,
                                       const std::function<bool()>& stop, std::int64_t& evaluated);

}  // namespace fourpost
