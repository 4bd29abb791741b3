#include "identify/uncertainty/output_spread.h"

#include <algorithm>
#include <cmath>

#include "identify/refine/fit_variables.h"
#include "identify/search/parallel.h"

namespace fourpost {

Eigen::MatrixXd OutputJacobian(const ParameterSpread& spread, Eigen::Index outputs, const OutputsOf& outputs_of,
                               int threads) {
  constexpr double kShare = 0.1;
  constexpr double kLeast = 1e-5;
  constexpr double kMost = 1e-2;
  const FitVariables variables(spread.lattice);
  const Eigen::VectorXd centre = variables.FromValues(spread.values);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(outputs, static_cast<Eigen::Index>(spread.judged.size()));
  ForEachInParallel(spread.judged.size(), ThreadCount(threads), [&](std::size_t column) {
    const auto k = static_cast<Eigen::Index>(column);
    const Eigen::Index j = spread.judged[column];
    const double step = std::clamp(kShare * std::sqrt(spread.total(k, k)), kLeast, kMost);
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

Eigen::VectorXd OutputVariances(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& covariance) {
  return (jacobian * covariance).cwiseProduct(jacobian).rowwise().sum().cwiseMax(0);
}

}  // namespace fourpost
