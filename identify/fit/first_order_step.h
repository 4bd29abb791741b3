#pragma once

#include <vector>

#include <Eigen/Core>

#include "identify/refine/refine.h"
#include "identify/residuals/vehicle_objective.h"

namespace fourpost {

/// The step from an optimum, n in FitVariables, that takes back what adds `gradient` (n) to that of its cost, to first
/// order; zero for parameters that are `held`. `data`: residuals that are not of priors.
Eigen::VectorXd FirstOrderStep(const RefineResult& best, const RobustLoss& loss, Eigen::Index data,
                               const std::vector<Eigen::Index>& held, const Eigen::VectorXd& gradient);

/// The step that is left to the optimum, n in FitVariables, to first order.
Eigen::VectorXd RemainingStep(const RefineResult& best, const RobustLoss& loss, Eigen::Index priors,
                              const std::vector<Eigen::Index>& held);

/// The step that an exact integration moves the optimum by, n in FitVariables: to first order, by residuals at a
/// quarter of the step. Empty where no block integrates, or one cannot be computed.
Eigen::VectorXd IntegrationStep(const VehicleObjective& objective, const RefineResult& best, const RobustLoss& loss,
                                const std::vector<Eigen::Index>& held);

}  // namespace fourpost
