#include "identify/experiments/four_post/modelled_response.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/files/csv_writer.h"
#include "analysis/signals/decibel.h"
#include "identify/experiments/four_post/response_bands.h"
#include "vehicles/response/hysteresis.h"
#include "vehicles/response/reduced_march.h"

namespace fourpost {
namespace {

double PhaseDeg(const std::complex<double>& response) { return DegreesFromRadians(std::arg(response)); }

void Blank(double frequency_Hz, FrequencyResponse& response) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < response.frequency_Hz.size(); ++i) {
    if (response.frequency_Hz[i] != frequency_Hz) continue;
    for (ChannelResponse& channel : response.channels) {
      channel.response[i] = {kNone, kNone};
      channel.mean[i] = channel.second_harmonic[i] = kNone;
    }
  }
}

/// What the deviation across a phasor is as an angle; NaN where there were no repeats.
double PhaseSdDeg(const MeasuredChannel& measured, std::size_t i) {
  if (!(measured.tangential_sd[i] > 0)) return std::numeric_limits<double>::quiet_NaN();
  return DegreesFromRadians(measured.tangential_sd[i] / std::abs(measured.response[i]));
}

/// `start`: null where it is unknown.
void AddRow(const MeasuredRun& run, const MeasuredChannel& measured, const ChannelResponse& modelled,
            const ChannelResponse* start, std::size_t i, bool in_band, CsvWriter& csv) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const bool has_mean = !measured.mean.empty();
  csv.Add(run.name).Add(measured.name).Add(measured.unit).Add(run.excitation.frequency_Hz[i]);
  csv.Add(run.excitation.amplitude_m[i]).Add(in_band ? 1 : 0);
  csv.Add(std::abs(measured.response[i])).Add(std::abs(modelled.response[i]));
  csv.Add(PhaseDeg(measured.response[i])).Add(PhaseDeg(modelled.response[i]));
  csv.Add(has_mean ? measured.mean[i] : none).Add(has_mean ? modelled.mean[i] : none);
  csv.Add(measured.radial_sd[i] > 0 ? measured.radial_sd[i] : none).Add(PhaseSdDeg(measured, i));
  csv.Add(start ? std::abs(start->response[i]) : none).Add(start ? PhaseDeg(start->response[i]) : none);
}

constexpr std::array<const char*, 4> kBandColumns = {"gain_half_95_parameters", "gain_half_95_measured",
                                                     "phase_half_95_parameters_deg", "phase_half_95_measured_deg"};

void AddBand(const ChannelBand& band, double gain, std::size_t i, CsvWriter& csv) {
  const auto angle = [&](double tangential) {
    return gain > 0 ? std::min(180.0, DegreesFromRadians(tangential / gain)) : std::nan("");
  };
  csv.Add(band.radial[i]).Add(band.radial_measured[i]);
  csv.Add(angle(band.tangential[i])).Add(angle(band.tangential_measured[i]));
}

/// By time integration.
PeriodicResponse Integrated(const CondensedModel& model, const std::vector<Sensor>& sensors,
                            const Excitation& excitation, const Deadline& deadline) {
  const RigView rig = {.sensors = sensors,
                       .post_count = excitation.shape.size(),
                       .tyre_stiffness = model.post_stiffness.cwiseAbs().maxCoeff()};
  MarchedResponse marched =
      MarchReduced(model, rig, excitation, {.tolerance = 1e-4, .longest_s = 20, .deadline = deadline});
  PeriodicResponse periodic{.response = std::move(marched.response)};
  for (const UnsteadyMotion& unsteady : marched.unsteady) periodic.unconverged_Hz.push_back(unsteady.frequency_Hz);
  return periodic;
}

/// What the balance did not find, until one frequency has no periodic motion at all.
void IntegrateUnconverged(const CondensedModel& model, const std::vector<Sensor>& sensors, const Excitation& excitation,
                          const Deadline& deadline, PeriodicResponse& periodic) {
  const std::vector<double> unconverged = std::exchange(periodic.unconverged_Hz, {});
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    const double frequency = excitation.frequency_Hz[i];
    if (std::find(unconverged.begin(), unconverged.end(), frequency) == unconverged.end()) continue;
    const PeriodicResponse one =
        Integrated(model, sensors, {{frequency}, {excitation.amplitude_m[i]}, excitation.shape}, deadline);
    if (!one.unconverged_Hz.empty()) {
      periodic.unconverged_Hz = unconverged;
      return;
    }
    for (std::size_t c = 0; c < one.response.channels.size(); ++c) {
      const ChannelResponse& from = one.response.channels[c];
      ChannelResponse& to = periodic.response.channels[c];
      to.response[i] = from.response[0];
      to.mean[i] = from.mean[0];
      to.second_harmonic[i] = from.second_harmonic[0];
    }
  }
}

}  // namespace

PeriodicResponse ModelledResponse(const CondensedModel& model, const std::vector<Sensor>& sensors,
                                  const Excitation& excitation, const Deadline& deadline, bool integrates) {
  if (HasHysteresis(model)) return Integrated(model, sensors, excitation, deadline);
  HarmonicBalanceOptions balance = kFitBalance;
  balance.deadline = deadline;
  PeriodicResponse periodic = SolveHarmonicBalance(model, sensors, excitation, balance);
  // A wheel that hops has a motion, though no few harmonics show it.
  const bool may_hop = !model.liftoffs.empty() || !model.curved_tyres.empty();
  if (integrates && may_hop && !periodic.unconverged_Hz.empty())
    IntegrateUnconverged(model, sensors, excitation, deadline, periodic);
  return periodic;
}

std::vector<FrequencyResponse> ModelledResponses(const CondensedModel& model, const std::vector<Sensor>& sensors,
                                                 const std::vector<MeasuredRun>& runs) {
  std::vector<FrequencyResponse> responses;
  for (const MeasuredRun& run : runs) {
    PeriodicResponse periodic = ModelledResponse(model, sensors, run.excitation);
    for (const double frequency : periodic.unconverged_Hz) Blank(frequency, periodic.response);
    responses.push_back(std::move(periodic.response));
  }
  return responses;
}

std::string ResponseCsv(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled,
                        double lower_Hz, double upper_Hz, const std::vector<FrequencyResponse>& start,
                        const std::vector<ResponseBands>& bands) {
  std::vector<std::string> columns = {
      "recording",      "channel",       "unit",          "frequency_Hz",       "post_amplitude_m",
      "in_band",        "gain_measured", "gain_modelled", "phase_measured_deg", "phase_modelled_deg",
      "mean_measured",  "mean_modelled", "gain_sd",       "phase_sd_deg",       "gain_start",
      "phase_start_deg"};
  if (!bands.empty()) columns.insert(columns.end(), kBandColumns.begin(), kBandColumns.end());
  CsvWriter csv(columns);
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (std::size_t c = 0; c < runs[r].channels.size(); ++c) {
      const MeasuredChannel& channel = runs[r].channels[c];
      for (std::size_t i = 0; i < channel.response.size(); ++i) {
        const double f = runs[r].excitation.frequency_Hz[i];
        const ChannelResponse* at_start = start.empty() ? nullptr : &start[r].channels[channel.sensor];
        AddRow(runs[r], channel, modelled[r].channels[channel.sensor], at_start, i,
               IsInBand(f, lower_Hz, upper_Hz) && !runs[r].is_validation, csv);
        if (!bands.empty())
          AddBand(bands[r].channels.at(c), std::abs(modelled[r].channels[channel.sensor].response[i]), i, csv);
      }
    }
  return csv.text();
}

}  // namespace fourpost
