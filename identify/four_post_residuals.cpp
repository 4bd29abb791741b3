#include "identify/four_post_residuals.h"

#include <cmath>
#include <complex>
#include <string>
#include <utility>

#include "analysis/decibel.h"
#include "identify/modelled_response.h"

namespace fourpost {
namespace {

Eigen::Index CountOf(const std::vector<MeasuredRun>& runs) {
  std::size_t count = 0;
  for (const MeasuredRun& run : runs)
    for (const MeasuredChannel& channel : run.channels) count += 2 * channel.response.size() + channel.mean.size();
  return static_cast<Eigen::Index>(count);
}

void AddRun(const MeasuredRun& run, const FrequencyResponse& modelled, const ModelError& model_error, double*& out) {
  const double gain_error = GainFromDecibel(model_error.gain_dB) - 1;
  for (const MeasuredChannel& channel : run.channels) {
    const ChannelResponse& model = modelled.channels[channel.sensor];
    for (std::size_t i = 0; i < channel.response.size(); ++i) {
      const double gain = std::abs(channel.response[i]);
      const std::complex<double> error =
          (model.response[i] - channel.response[i]) * std::conj(channel.response[i]) / gain;
      *out++ = error.real() / std::hypot(channel.radial_sd[i], gain * gain_error);
      *out++ = error.imag() / std::hypot(channel.tangential_sd[i], gain * model_error.phase_rad);
    }
    for (std::size_t i = 0; i < channel.mean.size(); ++i)
      *out++ = (model.mean[i] - channel.mean[i]) / model_error.mean_m;
  }
}

Evaluation Evaluate(const CondensedVehicle& vehicle, const std::vector<MeasuredRun>& runs, Eigen::Index count,
                    const ModelError& model_error, const std::vector<double>& values, const Deadline& deadline) {
  HarmonicBalanceOptions balance = kFitBalance;
  balance.deadline = deadline;
  const CondensedModel model = vehicle.At(values);
  Evaluation evaluation;
  evaluation.residuals.resize(count);
  double* out = evaluation.residuals.data();
  for (const MeasuredRun& run : runs) {
    const PeriodicResponse modelled = SolveHarmonicBalance(model, vehicle.vehicle().sensors, run.excitation, balance);
    if (!modelled.unconverged_Hz.empty())
      return Failed(Failure::kNotConverged, "no periodic response at " + std::to_string(modelled.unconverged_Hz[0]) +
                                                " Hz of '" + run.name + "'");
    AddRun(run, modelled.response, model_error, out);
  }
  return evaluation;
}

}  // namespace

ResidualBlock FourPostResiduals(std::shared_ptr<const CondensedVehicle> vehicle, std::vector<MeasuredRun> runs,
                                const ModelError& model_error) {
  const Eigen::Index count = CountOf(runs);
  return {.name = "four-post responses",
          .count = count,
          // What the balance's iteration leaves: 3e-7 of a response in the mean, some 1e-6 at the most.
          .accuracy = kFitBalance.tolerance,
          .evaluate = [vehicle = std::move(vehicle), runs = std::move(runs), count, model_error](
                          const std::vector<double>& values, const Deadline& deadline) {
            return Evaluate(*vehicle, runs, count, model_error, values, deadline);
          }};
}

ResidualBlock StaticLoadResiduals(std::shared_ptr<const CondensedVehicle> vehicle, std::vector<MeasuredLoad> loads) {
  const auto count = static_cast<Eigen::Index>(loads.size());
  return {.name = "static loads",
          .count = count,
          .evaluate = [vehicle = std::move(vehicle), loads = std::move(loads)](const std::vector<double>& values,
                                                                               const Deadline&) {
            const Preloads preloads = vehicle->PreloadsAt(values);
            Evaluation evaluation;
            evaluation.residuals.resize(static_cast<Eigen::Index>(loads.size()));
            double* out = evaluation.residuals.data();
            for (const MeasuredLoad& load : loads) *out++ = (preloads.tyre[load.tyre] - load.load_N) / load.sd_N;
            return evaluation;
          }};
}

}  // namespace fourpost
