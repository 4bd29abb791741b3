#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "identify/refine/fit_variables.h"
#include "identify/search/archive.h"

namespace fourpost {

/// Why derivatives are noise and the remedy; after the names of the parameters.
inline constexpr const char* kNoiseRemedy =
    "residuals jump between neighbouring values, so there is no standard deviation; try a model without "
    "the kink or the stiff element that this parameter belongs to, or `--profile`, which needs no derivative";

/// A Jacobian by differences again, in another way: by the model itself where it has derivatives, else by central
/// differences of a third of the `step`. Where residuals are smooth both say the same, and the shorter step leaves less
/// of the curvature; where they jump between neighbouring values the model knows nothing of the jumps, and the shorter
/// step makes three times as much of them. Nothing where a column has no point that can be evaluated. Its evaluations
/// are counted. Of the model's own Jacobian it is that one again: DerivativesHold() is what finds jumps there.
std::optional<Eigen::MatrixXd> JacobianAgain(Archive& archive, const FitVariables& variables, const Eigen::VectorXd& x,
                                             const Eigen::VectorXd& residuals, double step);

/// By how much two Jacobians of one point disagree: of each column the norm of the difference over the larger of both
/// norms, 0 to 2; 0 where both are zero.
Eigen::VectorXd Disagreement(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& again);

/// Columns that two Jacobians of one point, N x n, disagree on so far that neither gives a deviation: residuals jump
/// between neighbouring values there. Either the disagreement is above half of the column; or it is above that part of
/// the column which no other column has, and deviations differ by half. Not those whose effect is too small to count
/// beside that of the others, which are undetermined, whatever noise is left of them.
std::vector<Eigen::Index> NoisyColumns(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& again);

}  // namespace fourpost
