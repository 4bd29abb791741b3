#include "identify/fit/first_order_step.h"

#include <algorithm>
#include <stdexcept>

#include "analysis/numerics/decompositions.h"

namespace fourpost {

using Eigen::Index;

Eigen::VectorXd FirstOrderStep(const RefineResult& best, const RobustLoss& loss, Index data,
                               const std::vector<Index>& held, const Eigen::VectorXd& gradient) {
  std::vector<Index> moving;
  for (Index j = 0; j < best.jacobian.cols(); ++j)
    if (std::find(held.begin(), held.end(), j) == held.end()) moving.push_back(j);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(best.jacobian.cols());
  if (moving.empty()) return step;
  Eigen::MatrixXd weighted = best.jacobian(Eigen::all, moving);
  const Eigen::VectorXd weights = loss.OfData().Weights(best.residuals.head(data));
  weighted.topRows(data) = weights.cwiseSqrt().asDiagonal() * weighted.topRows(data);
  step(moving) = LeastNorm(weighted.transpose() * weighted).Solve(Eigen::VectorXd(-gradient(moving)));
  return step;
}

Eigen::VectorXd RemainingStep(const RefineResult& best, const RobustLoss& loss, Index priors,
                              const std::vector<Index>& held) {
  const Index data = best.jacobian.rows() - priors;
  Eigen::VectorXd residuals = best.residuals;
  residuals.head(data).array() *= loss.OfData().Weights(best.residuals.head(data)).array();
  return FirstOrderStep(best, loss, data, held, best.jacobian.transpose() * residuals);
}

std::optional<Eigen::VectorXd> FinerResiduals(const VehicleObjective& objective, const RefineResult& point) {
  Eigen::VectorXd residuals = point.residuals;
  bool integrates = false;
  Index at = 0;
  try {
    for (const ResidualBlock& block : objective.blocks()) {
      if (block.at_finer_steps) {
        residuals.segment(at, block.count) = block.at_finer_steps(objective.AllParameters(point.values));
        integrates = true;
      }
      at += block.count;
    }
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
  if (!integrates || !residuals.allFinite()) return std::nullopt;
  return residuals;
}

Eigen::VectorXd IntegrationStep(const VehicleObjective& objective, const RefineResult& best,
                                const Eigen::VectorXd& finer, const RobustLoss& loss, const std::vector<Index>& held) {
  const Index data = best.jacobian.rows() - objective.prior_count();
  const Eigen::VectorXd change = (finer - best.residuals).head(data);
  const Eigen::VectorXd weights = loss.OfData().Weights(best.residuals.head(data));
  return FirstOrderStep(best, loss, data, held, best.jacobian.topRows(data).transpose() * weights.cwiseProduct(change));
}

}  // namespace fourpost
