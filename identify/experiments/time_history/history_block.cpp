#include "identify/experiments/time_history/history_block.h"

#include <algorithm>
#include <functional>
#include <span>
#include <stdexcept>
#include <utility>

namespace fourpost {
namespace {

/// Nothing known of it is taken for noise that may be there.
bool MayHavePostNoise(const std::vector<MeasuredHistory>& histories) {
  for (const MeasuredHistory& history : histories)
    for (std::size_t p = 0; p < history.post_noise_sd.size(); ++p)
      if (history.post_noise_sd[p] > 0 || !history.post_noise_is_stated[p]) return true;
  return false;
}

/// See ResidualBlock::with_input_noise.
std::vector<ResidualBlock> WithPostNoise(const HistoryResiduals& residuals,
                                         const std::shared_ptr<const CondensedVehicle>& vehicle,
                                         const std::vector<Calibration>& calibrations,
                                         const std::vector<double>& values) {
  const std::vector<PostNoise> noise = residuals.PostNoiseAt(values);
  if (std::none_of(noise.begin(), noise.end(), [](const PostNoise& one) { return one.IsAny(); })) return {};
  std::vector<ResidualBlock> both;
  for (const double sign : {-1.0, 1.0}) {
    std::vector<MeasuredHistory> noisy;
    for (std::size_t h = 0; h < noise.size(); ++h)
      noisy.push_back(WithPostNoise(residuals.histories()[h], noise[h], h, sign));
    both.push_back(HistoryBlock(vehicle, std::move(noisy), residuals.options(), calibrations));
  }
  return both;
}

}  // namespace

ResidualBlock HistoryBlock(std::shared_ptr<const CondensedVehicle> vehicle, std::vector<MeasuredHistory> histories,
                           const HistoryResiduals::Options& options, const std::vector<Calibration>& calibrations) {
  const bool has_noise = options.cost == HistoryCost::kWhitened && MayHavePostNoise(histories);
  const auto residuals = std::make_shared<const HistoryResiduals>(vehicle, std::move(histories), options);
  std::function<Eigen::VectorXd(const std::vector<double>&)> at_finer_steps;
  if (options.cost == HistoryCost::kWhitened)
    at_finer_steps = [residuals](const std::vector<double>& values) { return residuals->AtFinerSteps(values); };
  std::function<std::vector<ResidualBlock>(const std::vector<double>&)> with_input_noise;
  if (has_noise)
    with_input_noise = [=](const std::vector<double>& values) {
      return WithPostNoise(*residuals, vehicle, calibrations, values);
    };
  std::function<Eigen::MatrixXd(const std::vector<double>&)> by_calibrations;
  if (options.cost == HistoryCost::kWhitened && !calibrations.empty())
    by_calibrations = [residuals, calibrations](const std::vector<double>& values) {
      return residuals->ByCalibrations(calibrations, values);
    };
  decltype(ResidualBlock::differentiate) differentiate;
  decltype(ResidualBlock::toward) toward;
  if (residuals->HasDerivatives()) {
    differentiate = [residuals](const std::vector<double>& values, const std::vector<std::size_t>& parameters) {
      return residuals->Derivatives(values, parameters);
    };
    toward = [residuals](const std::vector<double>& values, std::span<const OtherVehicle> others) {
      return residuals->Toward(values, others);
    };
  }
  return {.name = "time histories",
          .count = residuals->count(),
          // What the elements' forces are solved to, times what a step's error may grow to.
          .accuracy = 1e-9,
          .evaluate =
              [residuals](const std::vector<double>& values, const Deadline& deadline) {
                try {
                  return Evaluation{.residuals = residuals->At(values, deadline)};
                } catch (const std::runtime_error& fault) {
                  return Failed(Failure::kNotConverged, fault.what());
                }
              },
          .differentiate = std::move(differentiate),
          .toward = std::move(toward),
          .at_finer_steps = std::move(at_finer_steps),
          .by_calibrations = std::move(by_calibrations),
          .structure = residuals->Structure(),
          .with_input_noise = std::move(with_input_noise)};
}

}  // namespace fourpost
