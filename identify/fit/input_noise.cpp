#include "identify/fit/input_noise.h"

#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

#include "identify/fit/calibration_changes.h"
#include "identify/fit/first_order_step.h"
#include "identify/refine/difference_jacobian.h"
#include "identify/refine/fit_variables.h"
#include "identify/search/archive.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Blocks with noise added, and with the same taken away; none where no input has noise.
using NoisyBlocks = std::array<std::vector<ResidualBlock>, 2>;

NoisyBlocks WithNoise(const VehicleObjective& objective, const Eigen::VectorXd& values) {
  NoisyBlocks noisy;
  bool has_noise = false;
  for (const ResidualBlock& block : objective.blocks()) {
    std::vector<ResidualBlock> both;
    if (block.with_input_noise) both = block.with_input_noise(objective.AllParameters(values));
    has_noise = has_noise || !both.empty();
    for (std::size_t i = 0; i < noisy.size(); ++i) noisy[i].push_back(both.empty() ? block : both[i]);
  }
  return has_noise ? noisy : NoisyBlocks();
}

struct Linearised {
  /// Of the data.
  Eigen::VectorXd residuals;
  /// By calibrations as `gradient` is by parameters; without columns where that cannot be evaluated.
  Eigen::MatrixXd of_calibrations;
  /// By residuals, N x n: derivatives times weighted residuals.
  Eigen::MatrixXd gradient;
};

/// Of these blocks. Throws BatchStopped.
std::optional<Linearised> LinearisedOf(std::vector<ResidualBlock> blocks, const VehicleObjective& objective,
                                       const Eigen::VectorXd& values, const RefineOptions& refine, int threads,
                                       const std::function<bool()>& stop, std::int64_t& evaluated) {
  const VehicleObjective noisy(objective.vehicle(), objective.free(), std::move(blocks), objective.calibrations());
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
  const auto weighted = residuals.cwiseProduct(refine.loss.OfData().Weights(residuals)).eval();
  return Linearised{.residuals = residuals,
                    .of_calibrations = weighted.asDiagonal() * CalibrationChanges(noisy, values),
                    .gradient = weighted.asDiagonal() * jacobian->topRows(data)};
}

}  // namespace

std::optional<InputNoise> InputNoiseAt(const VehicleObjective& objective, const RefineResult& best,
                                       const RefineOptions& refine, const std::vector<Index>& held, int threads,
                                       const std::function<bool()>& stop, std::int64_t& evaluated) {
  if (stop()) return std::nullopt;
  const Index data = best.jacobian.rows() - objective.prior_count();
  const Eigen::VectorXd residuals = best.residuals.head(data);
  const Eigen::VectorXd weighted = residuals.cwiseProduct(refine.loss.OfData().Weights(residuals));
  const Eigen::MatrixXd changes = CalibrationChanges(objective, best.values);
  InputNoise noise = {.gradient = -(weighted.asDiagonal() * best.jacobian.topRows(data)),
                      .of_calibrations = -(weighted.asDiagonal() * changes),
                      .step = {}};
  Eigen::VectorXd change = Eigen::VectorXd::Zero(data);
  try {
    for (std::vector<ResidualBlock>& blocks : WithNoise(objective, best.values)) {
      if (blocks.empty()) return std::nullopt;
      const auto with = LinearisedOf(std::move(blocks), objective, best.values, refine, threads, stop, evaluated);
      if (!with) return std::nullopt;
      noise.gradient += 0.5 * with->gradient;
      if (with->of_calibrations.cols() == noise.of_calibrations.cols())
        noise.of_calibrations += 0.5 * with->of_calibrations;
      else noise.of_calibrations.resize(data, 0);
      change = 0.5 * with->residuals - change;
    }
  } catch (const BatchStopped&) {
    return std::nullopt;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
  // Half the difference of both, in which all that the noise did not change cancels.
  noise.squares = change.squaredNorm();
  noise.step = FirstOrderStep(best, refine.loss, data, held, -noise.gradient.colwise().sum().transpose());
  return noise;
}

}  // namespace fourpost
