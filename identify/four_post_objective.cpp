#include "identify/four_post_objective.h"

#include <cmath>

#include "analysis/decibel.h"
#include "analysis/option_check.h"
#include "identify/modelled_response.h"

namespace fourpost {

FourPostObjective::FourPostObjective(Vehicle vehicle, std::vector<MeasuredRun> runs,
                                     std::vector<MeasuredLoad> static_loads, std::vector<std::size_t> free,
                                     ModelError model_error)
    : vehicle_(std::move(vehicle)),
      condensed_(vehicle_),
      runs_(std::move(runs)),
      static_loads_(std::move(static_loads)),
      free_(std::move(free)),
      model_error_(model_error) {
  for (const MeasuredRun& run : runs_)
    for (const MeasuredChannel& channel : run.channels)
      residual_count_ += static_cast<Eigen::Index>(2 * channel.response.size() + channel.mean.size());
  CollectPriors();
  residual_count_ += static_cast<Eigen::Index>(static_loads_.size()) + prior_count();
}

void FourPostObjective::CollectPriors() {
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const Parameter& parameter = vehicle_.parameters[free_[i]];
    if (!parameter.prior_sd) continue;
    const double sd = *parameter.prior_sd;
    RequireOption(sd > 0 && std::isfinite(sd), "prior_sd of " + parameter.name, sd, "positive and finite");
    priors_.push_back({static_cast<Eigen::Index>(i), parameter.value, sd});
  }
}

Problem FourPostObjective::MakeProblem() const {
  std::vector<LatticeAxis> axes;
  for (const std::size_t index : free_) {
    const Parameter& parameter = vehicle_.parameters[index];
    axes.push_back({parameter.name, parameter.lower, parameter.upper, parameter.precision});
  }
  return {.lattice = Lattice(std::move(axes)),
          .evaluate = [this](const Eigen::VectorXd& values,
                             const Deadline& deadline) { return Evaluate(values, deadline); },
          .residual_count = residual_count_,
          // What the balance's iteration leaves: 3e-7 of a response in the mean, some 1e-6 at the most.
          .accuracy = kFitBalance.tolerance};
}

std::vector<double> FourPostObjective::AllParameters(const Eigen::VectorXd& values) const {
  std::vector<double> all = vehicle_.ParameterValues();
  for (std::size_t i = 0; i < free_.size(); ++i) all[free_[i]] = values[static_cast<Eigen::Index>(i)];
  return all;
}

Evaluation FourPostObjective::Evaluate(const Eigen::VectorXd& values, const Deadline& deadline) const {
  HarmonicBalanceOptions balance = kFitBalance;
  balance.deadline = deadline;
  const CondensedModel model = condensed_.At(AllParameters(values));
  Evaluation evaluation;
  evaluation.residuals.resize(residual_count_);
  double* out = evaluation.residuals.data();
  for (const MeasuredRun& run : runs_) {
    const PeriodicResponse modelled = SolveHarmonicBalance(model, vehicle_.sensors, run.excitation, balance);
    if (!modelled.unconverged_Hz.empty())
      return Failed(Failure::kNotConverged, "no periodic response at " + std::to_string(modelled.unconverged_Hz[0]) +
                                                " Hz of '" + run.name + "'");
    AddRun(run, modelled.response, out);
  }
  for (const MeasuredLoad& load : static_loads_) *out++ = (model.preloads.tyre[load.tyre] - load.load_N) / load.sd_N;
  evaluation.residuals.tail(prior_count()) = PriorResiduals(values);
  return evaluation;
}

Eigen::VectorXd FourPostObjective::PriorResiduals(const Eigen::VectorXd& values) const {
  Eigen::VectorXd residuals(prior_count());
  double* out = residuals.data();
  for (const Prior& prior : priors_) *out++ = (values[prior.index] - prior.value) / prior.sd;
  return residuals;
}

void FourPostObjective::AddRun(const MeasuredRun& run, const FrequencyResponse& modelled, double*& out) const {
  const double gain_error = GainFromDecibel(model_error_.gain_dB) - 1;
  for (const MeasuredChannel& channel : run.channels) {
    const ChannelResponse& model = modelled.channels[channel.sensor];
    for (std::size_t i = 0; i < channel.response.size(); ++i) {
      const double gain = std::abs(channel.response[i]);
      const std::complex<double> error =
          (model.response[i] - channel.response[i]) * std::conj(channel.response[i]) / gain;
      *out++ = error.real() / std::hypot(channel.radial_sd[i], gain * gain_error);
      *out++ = error.imag() / std::hypot(channel.tangential_sd[i], gain * model_error_.phase_rad);
    }
    for (std::size_t i = 0; i < channel.mean.size(); ++i)
      *out++ = (model.mean[i] - channel.mean[i]) / model_error_.mean_m;
  }
}

}  // namespace fourpost
