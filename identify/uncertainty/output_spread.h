#pragma once

#include <functional>

#include <Eigen/Core>

#include "identify/uncertainty/parameter_spread.h"

namespace fourpost {

/// m outputs of a model for values of the n free parameters, SI; of another size where it cannot be evaluated.
using OutputsOf = std::function<Eigen::VectorXd(const Eigen::VectorXd& values)>;

/// d outputs / d FitVariables of the judged parameters at the fitted values, m x judged, by central differences, one
/// sided at a bound; two evaluations each. The steps are a tenth of the deviations, so that kinks are seen on the scale
/// on which the parameters are known. A column that cannot be evaluated is zero. `threads`: that call `outputs_of` at
/// once.
Eigen::MatrixXd OutputJacobian(const ParameterSpread& spread, Eigen::Index outputs, const OutputsOf& outputs_of,
                               int threads = 1);

/// d value [SI] / d FitVariables of each judged parameter.
Eigen::VectorXd JudgedSlopes(const ParameterSpread& spread);

/// Whether such a Jacobian that the model supplies itself may stand for one by differences: central differences along
/// two directions, in which every parameter moves by a tenth of its deviation, agree with it to within 5 % of that
/// change, each output over its deviation. Four evaluations. Not next to a bound.
bool OutputDerivativesHold(const ParameterSpread& spread, const Eigen::MatrixXd& jacobian, const OutputsOf& outputs_of);

/// Variances of the outputs, J S J' on its diagonal, to first order (Gauss).
Eigen::VectorXd OutputVariances(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& covariance);

}  // namespace fourpost
