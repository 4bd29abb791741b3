#include "identify/uncertainty/output_spread.h"

#include <algorithm>
#include <cmath>

#include "identify/refine/fit_variables.h"
#include "identify/search/parallel.h"

namespace fourpost {

namespace {

/// Of a judged parameter.
double StepOf(const ParameterSpread& spread, Eigen::Index k) {
  constexpr double kShare = 0.1;
  constexpr double kLeast = 1e-5;
  constexpr double kMost = 1e-2;
  return std::clamp(kShare * std::sqrt(spread.total(k, k)), kLeast, kMost);
}

}  // namespace

Eigen::MatrixXd OutputJacobian(const ParameterSpread& spread, Eigen::Index outputs, const OutputsOf& outputs_of,
                               int threads) {
  const FitVariables variables(spread.lattice);
  const Eigen::VectorXd centre = variables.FromValues(spread.values);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(outputs, static_cast<Eigen::Index>(spread.judged.size()));
  ForEachInParallel(spread.judged.size(), ThreadCount(threads), [&](std::size_t column) {
    const auto k = static_cast<Eigen::Index>(column);
    const Eigen::Index j = spread.judged[column];
    const double step = StepOf(spread, k);
    const double above = std::min(centre[j] + step, variables.upper()[j]);
    const double below = std::max(centre[j] - step, variables.lower()[j]);
    const auto at = [&](double x) {
      Eigen::VectorXd moved = spread.values;
      Eigen::VectorXd moved_x = centre;
      moved_x[j] = x;
      moved[j] = variables.ToValues(moved_x)[j];
      return outputs_of(moved);
    };
    const Eigen::VectorXd up = at(above);
    const Eigen::VectorXd down = at(below);
    if (up.size() == outputs && down.size() == outputs && above > below)
      jacobian.col(k) = (up - down) / (above - below);
  });
  return jacobian;
}

Eigen::VectorXd JudgedSlopes(const ParameterSpread& spread) {
  return FitVariables(spread.lattice).Slopes(spread.values)(spread.judged);
}

bool OutputDerivativesHold(const ParameterSpread& spread, const Eigen::MatrixXd& jacobian,
                           const OutputsOf& outputs_of) {
  constexpr double kAgreement = 0.05;
  if (!jacobian.allFinite()) return false;
  const FitVariables variables(spread.lattice);
  const Eigen::VectorXd centre = variables.FromValues(spread.values);
  const Eigen::VectorXd deviations = OutputVariances(jacobian, spread.total).cwiseSqrt();
  const Eigen::VectorXd weights = (deviations.array() > 0).select(deviations.cwiseInverse(), 0);
  for (const Eigen::Index turns : {1, 2}) {
    Eigen::VectorXd direction(jacobian.cols());
    Eigen::VectorXd above = centre;
    Eigen::VectorXd below = centre;
    for (Eigen::Index k = 0; k < direction.size(); ++k) {
      const Eigen::Index j = spread.judged[static_cast<std::size_t>(k)];
      const double room = std::min(variables.upper()[j] - centre[j], centre[j] - variables.lower()[j]);
      if (room < StepOf(spread, k)) return false;
      direction[k] = StepOf(spread, k) * (k / turns % 2 == 1 ? -1 : 1);
      above[j] += direction[k];
      below[j] -= direction[k];
    }
    const Eigen::VectorXd up = outputs_of(variables.ToValues(above));
    const Eigen::VectorXd down = outputs_of(variables.ToValues(below));
    if (up.size() != jacobian.rows() || down.size() != jacobian.rows()) return false;
    const Eigen::VectorXd expected = weights.cwiseProduct(jacobian * direction);
    const Eigen::VectorXd found = weights.cwiseProduct(up - down) / 2;
    // Not where nothing changes, or something is not a number.
    if (!((found - expected).norm() <= kAgreement * expected.norm())) return false;
  }
  return true;
}

Eigen::VectorXd OutputVariances(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& covariance) {
  return (jacobian * covariance).cwiseProduct(jacobian).rowwise().sum().cwiseMax(0);
}

}  // namespace fourpost
