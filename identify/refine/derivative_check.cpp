#include "identify/refine/derivative_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
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

/// Every variable that is not at a bound changes the residuals by as much, `turns` of them up, then as many down.
/// Nothing where one would go beyond a bound.
std::optional<Eigen::VectorXd> Direction(const FitVariables& variables, const Eigen::VectorXd& x,
                                         const Eigen::MatrixXd& jacobian, double step, Eigen::Index turns) {
  constexpr double kAtBound = 1e-6;
  Eigen::VectorXd direction = jacobian.colwise().norm().cwiseInverse().transpose();
  direction /= direction.maxCoeff();
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const double room = std::min(x[j] - variables.lower()[j], variables.upper()[j] - x[j]);
    const double range = variables.upper()[j] - variables.lower()[j];
    if (room <= kAtBound * range) direction[j] = 0;
    else if (step * direction[j] > room) return std::nullopt;
    if (j / turns % 2 == 1) direction[j] = -direction[j];
  }
  return direction;
}

bool HasDiscrete(const Lattice& lattice) {
  return std::any_of(lattice.axes().begin(), lattice.axes().end(),
                     [](const LatticeAxis& axis) { return axis.discrete; });
}

/// `error`: of the change along a direction. Along it the optimum moves by less than a tenth of its deviation.
bool IsSmall(const Eigen::VectorXd& error, const Eigen::VectorXd& expected, const Eigen::VectorXd& residuals,
             Eigen::Index variables) {
  constexpr double kMove = 0.1;
  const auto freedom = static_cast<double>(std::max<Eigen::Index>(1, residuals.size() - variables));
  const double deviation = residuals.norm() / std::sqrt(freedom);
  return expected.norm() > 0 && error.norm() <= kAgreement * expected.norm() &&
         std::abs(error.dot(residuals)) <= kMove * deviation * expected.norm();
}

}  // namespace

bool DerivativesHold(Archive& archive, const FitVariables& variables, const Eigen::VectorXd& x,
                     const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian, double step) {
  if (!jacobian.allFinite() || HasDiscrete(archive.lattice()) || HasSmallSlope(jacobian)) return false;
  for (const Eigen::Index turns : {1, 2}) {
    const std::optional<Eigen::VectorXd> direction = Direction(variables, x, jacobian, step, turns);
    if (!direction) return false;
    const Eigen::VectorXd expected = jacobian * *direction;
    const std::vector<Evaluation> ends =
        archive.EvaluateValues({variables.ToValues(x + step * *direction), variables.ToValues(x - step * *direction)});
    if (!ends[0].ok() || !ends[1].ok()) return false;
    const Eigen::VectorXd found = (ends[0].residuals - ends[1].residuals) / (2 * step);
    if (!IsSmall(found - expected, expected, residuals, x.size())) return false;
  }
  return true;
}

}  // namespace fourpost
