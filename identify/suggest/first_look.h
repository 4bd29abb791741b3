#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "identify/residuals/vehicle_objective.h"
#include "identify/suggest/augmented_study.h"

namespace fourpost {

/// An addition to look at, and how much of it.
struct FirstLook {
  const AugmentedStudy* study = nullptr;
  double amount = 0;
};

/// Residuals with each addition, to first order in it, for much less than evaluating them: all of a group together
/// follow the fitted motion. Nothing of an addition to which that does not apply, such as a body of its own, that
/// throws, or whose evaluation of the other blocks takes longer than the study allows.
/// `residuals`: those at `values` of the study's own objective. Which additions share a group changes no digit.
std::vector<std::optional<Eigen::VectorXd>> LookAt(const VehicleObjective& objective, const Eigen::VectorXd& values,
                                                   const Eigen::VectorXd& residuals, std::span<const FirstLook> looks);

}  // namespace fourpost
