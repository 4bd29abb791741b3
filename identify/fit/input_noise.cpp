#include "identify/fit/input_noise.h"

#include <algorithm>
#include <utility>

#include "identify/fit/first_order_step.h"
#include "identify/refine/difference_jacobian.h"
#include "identify/refine/fit_variables.h"
#include "identify/search/archive.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Its gradient by residuals, N x n: derivatives times weighted residuals. Throws BatchStopped.
std::optional<Eigen::MatrixXd> GradientWith(const VehicleObjective& objective, const Eigen::VectorXd& values,
                                            double sign, const RefineOptions& refine, int threads,
                                            const std::function<bool()>& stop, std::int64_t& evaluated) {
  std::vector<ResidualBlock> blocks;
  for (const ResidualBlock& block : objective.blocks())
    blocks.push_back(block.with_input_noise ? block.with_input_noise(objective.AllParameters(values), sign) : block);
  const VehicleObjective noisy(objective.vehicle(), objective.free(), std::move(blocks));
  Archive archive(noisy.MakeProblem(), threads);
  archive.StopBatches(stop);
  const Evaluation here = archive.EvaluateValues({values}).front();
  if (!here.ok()) return std::nullopt;
  const FitVariables variables(archive.lattice());
  const std::optional<Eigen::MatrixXd> jacobian =
      DifferenceJacobian(archive, variables, variables.FromValues(values), here.residuals,
                         refine.DifferenceStep(archive.problem()), Differences::kCentral);
  evaluated += archive.counts().paid;
  if (!jacobian) return std::nullopt;
  const Index data = here.residuals.size() - objective.prior_count();
  const Eigen::VectorXd residuals = here.residuals.head(data);
  return residuals.cwiseProduct(refine.loss.Weights(residuals)).asDiagonal() * jacobian->topRows(data);
}

}  // namespace

std::optional<InputNoise> InputNoiseAt(const VehicleObjective& objective, const RefineResult& best,
                                       const RefineOptions& refine, const std::vector<Index>& held, int threads,
                                       const std::function<bool()>& stop, std::int64_t& evaluated) {
  const auto& blocks = objective.blocks();
  const bool has_noise = std::any_of(blocks.begin(), blocks.end(), [](const ResidualBlock& block) {
    return static_cast<bool>(block.with_input_noise);
  });
  if (!has_noise || stop()) return std::nullopt;
  const Index data = best.jacobian.rows() - objective.prior_count();
  const Eigen::VectorXd residuals = best.residuals.head(data);
  const Eigen::VectorXd weights = refine.loss.Weights(residuals);
  InputNoise noise = {.gradient = -(residuals.cwiseProduct(weights).asDiagonal() * best.jacobian.topRows(data)),
                      .step = {}};
  try {
    for (const double sign : {-1.0, 1.0}) {
      const auto with = GradientWith(objective, best.values, sign, refine, threads, stop, evaluated);
      if (!with) return std::nullopt;
      noise.gradient += 0.5 * *with;
    }
  } catch (const BatchStopped&) {
    return std::nullopt;
  }
  noise.step = FirstOrderStep(best, refine.loss, data, held, -noise.gradient.colwise().sum().transpose());
  return noise;
}

}  // namespace fourpost
