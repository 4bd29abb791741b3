#include "identify/refine/derivative_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

/// Of the change along a direction. The models' own derivatives are within 1 % of each column's norm.
constexpr double kAgreement = 0.02;
/// Smallest singular value of columns of length one. Their errors, spread over all residuals, weigh some 1e-3 in any
/// direction.
constexpr double kLeastSlope = 3e-3;

bool HasSmallSlope(const Eigen::MatrixXd& jacobian) {
  const Eigen::VectorXd norms = jacobian.colwise().norm();
  if (!(norms.minCoeff() > std::numeric_limits<double>::epsilon() * norms.maxCoeff())) return true;
  const Eigen::MatrixXd unit = jacobian * norms.cwiseInverse().asDiagonal();
  const Eigen::VectorXd squares = SymmetricEigenvaluesOf(unit.transpose() * unit);
  return squares.minCoeff() < kLeastSlope * kLeastSlope * squares.maxCoeff();
}

/// In turns up and down; zero for a variable next to a bound.
Eigen::VectorXd Direction(const FitVariables& variables, const Eigen::VectorXd& x, const Eigen::MatrixXd& jacobian,
                          double step) {
  Eigen::VectorXd direction = jacobian.colwise().norm().cwiseInverse().transpose();
  direction /= direction.maxCoeff();
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const double move = step * direction[j];
    if (x[j] - move < variables.lower()[j] || x[j] + move > variables.upper()[j]) direction[j] = 0;
    else if (j % 2 == 1) direction[j] = -direction[j];
  }
  return direction;
}

}  // namespace

bool DerivativesHold(Archive& archive, const FitVariables& variables, const Eigen::VectorXd& x,
                     const Eigen::MatrixXd& jacobian, double step) {
  if (!jacobian.allFinite() || HasSmallSlope(jacobian)) return false;
  const Eigen::VectorXd direction = Direction(variables, x, jacobian, step);
  const Eigen::VectorXd expected = jacobian * direction;
  const std::vector<Evaluation> ends =
      archive.EvaluateValues({variables.ToValues(x + step * direction), variables.ToValues(x - step * direction)});
  if (!ends[0].ok() || !ends[1].ok()) return false;
  const Eigen::VectorXd found = (ends[0].residuals - ends[1].residuals) / (2 * step);
  return (found - expected).norm() <= kAgreement * expected.norm();
}

}  // namespace fourpost
