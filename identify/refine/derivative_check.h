#pragma once

#include <Eigen/Core>

#include "identify/refine/fit_variables.h"
#include "identify/search/archive.h"

namespace fourpost {

/// Whether a Jacobian that the model supplies itself may stand for one by differences: central differences along two
/// directions, in which every variable changes the residuals by as much, agree with it to within 2 % of that change and
/// to a tenth of a deviation of the optimum, and no direction's slope is so small that the model's errors could decide
/// whether it is there at all. Four evaluations. Never with discrete variables. `x`: in the fit variables, where the
/// `residuals` are; `step`: of the differences.
bool DerivativesHold(Archive& archive, const FitVariables& variables, const Eigen::VectorXd& x,
                     const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian, double step);

}  // namespace fourpost
