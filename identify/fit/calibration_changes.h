#pragma once

#include <Eigen/Core>

#include "identify/residuals/vehicle_objective.h"

namespace fourpost {

/// What one standard deviation of each calibration changes in the residuals, those of priors left out, N x
/// calibrations; without columns where the model cannot be evaluated.
Eigen::MatrixXd CalibrationChanges(const VehicleObjective& objective, const Eigen::VectorXd& values);

}  // namespace fourpost
