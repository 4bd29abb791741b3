#pragma once

#include <optional>
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

/// Residuals at a point of a refinement, those of blocks that integrate at a quarter of the step. Empty where no block
/// integrates, or one cannot be computed.
std::optional<Eigen::VectorXd> FinerResiduals(const VehicleObjective& objective, const RefineResult& point);

/// The step by which these residuals have their optimum elsewhere, n in FitVariables, to first order.
Eigen::VectorXd IntegrationStep(const VehicleObjective& objective, const RefineResult& best,
                                const Eigen::VectorXd& finer, const RobustLoss& loss,
                                const std::vector<Eigen::Index>& held);

}  // namespace fourpost
