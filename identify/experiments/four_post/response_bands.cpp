#include "identify/experiments/four_post/response_bands.h"

#include <atomic>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "identify/experiments/fit_balance.h"
#include "identify/experiments/four_post/modelled_response.h"
#include "identify/experiments/freed_parameters.h"
#include "identify/uncertainty/output_spread.h"
#include "vehicles/response/balance_sensitivity.h"
#include "vehicles/response/hysteresis.h"

namespace fourpost {
namespace {

using Eigen::Index;

constexpr double kReach = 1.959963984540054;

/// Errors along and across the modelled phasors, channel by channel: what derivatives are taken of.
Eigen::VectorXd AlongPhasors(const MeasuredRun& run, const FrequencyResponse& centre,
                             const FrequencyResponse& response) {
  Index count = 0;
  for (const MeasuredChannel& channel : run.channels) count += 2 * static_cast<Index>(channel.response.size());
  Eigen::VectorXd along(count);
  double* out = along.data();
  for (const MeasuredChannel& channel : run.channels)
    for (std::size_t i = 0; i < channel.response.size(); ++i) {
      const std::complex<double> about = centre.channels[channel.sensor].response[i];
      const std::complex<double> turn = std::abs(about) > 0 ? std::conj(about) / std::abs(about) : 1.0;
      const std::complex<double> turned = response.channels[channel.sensor].response[i] * turn;
      *out++ = turned.real();
      *out++ = turned.imag();
    }
  return along;
}

bool IsGainOutside(const std::complex<double>& measured, const std::complex<double>& modelled, double half_width) {
  return std::abs(std::abs(measured) - std::abs(modelled)) > half_width;
}

/// On an arc about the modelled phasor; one of half a circle holds all.
bool IsPhaseOutside(const std::complex<double>& measured, const std::complex<double>& modelled, double half_width) {
  const double radius = std::abs(modelled);
  return half_width < std::numbers::pi * radius && std::abs(std::arg(measured / modelled)) * radius > half_width;
}

BandCount Outside(const MeasuredChannel& measured, const ChannelResponse& modelled, const ChannelBand& band) {
  BandCount count{.channel = measured.name};
  for (std::size_t i = 0; i < measured.response.size(); ++i) {
    if (!std::isfinite(band.radial_measured[i])) continue;
    count.points += 2;
    count.outside += IsGainOutside(measured.response[i], modelled.response[i], band.radial_measured[i]);
    count.outside += IsPhaseOutside(measured.response[i], modelled.response[i], band.tangential_measured[i]);
  }
  return count;
}

/// d AlongPhasors() / d FitVariables of the judged parameters, by the model's own derivatives; none where it has none.
std::optional<Eigen::MatrixXd> OwnJacobian(const Subject& subject, const MeasuredRun& run,
                                           const FrequencyResponse& modelled, const ParameterSpread& spread,
                                           const FreedParameters& freed) {
  const std::vector<double> values = freed.AllWith(spread.values);
  if (HasHysteresis(subject.Condensed()->At(values))) return std::nullopt;
  std::vector<std::size_t> parameters;
  for (const Index j : spread.judged) parameters.push_back(freed.Place(j));
  const Eigen::VectorXd slopes = JudgedSlopes(spread);
  try {
    const ResponseSensitivity sensitivity =
        SolveBalanceSensitivity(*subject.Condensed(), values, parameters, run.excitation, kFitBalance);
    if (!sensitivity.periodic.unconverged_Hz.empty()) return std::nullopt;
    Eigen::MatrixXd jacobian(AlongPhasors(run, modelled, modelled).size(), std::ssize(parameters));
    for (Index k = 0; k < jacobian.cols(); ++k)
      jacobian.col(k) = slopes[k] * AlongPhasors(run, modelled, sensitivity.by_change[static_cast<std::size_t>(k)]);
    return jacobian;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace

ResponseBands BandsOfResponse(const Subject& subject, const MeasuredRun& run, const FrequencyResponse& modelled,
                              const ParameterSpread& spread, const std::vector<OctaveDiscrepancy>& discrepancies,
                              int threads) {
  const FreedParameters freed(spread, subject.vehicle());
  if (!freed.AreKnown() || discrepancies.empty()) return {};
  ResponseBands bands;
  std::atomic<std::int64_t> evaluations = 0;
  const auto response_at = [&](const Eigen::VectorXd& free) -> Eigen::VectorXd {
    ++evaluations;
    try {
      const CondensedModel model = subject.Condensed()->At(freed.AllWith(free));
      return AlongPhasors(run, modelled, ModelledResponses(model, subject.vehicle().sensors, {run}).front());
    } catch (const std::runtime_error&) {
      return {};
    }
  };
  const Index count = AlongPhasors(run, modelled, modelled).size();
  std::optional<Eigen::MatrixXd> jacobian = OwnJacobian(subject, run, modelled, spread, freed);
  if (!jacobian || !OutputDerivativesHold(spread, *jacobian, response_at))
    jacobian = OutputJacobian(spread, count, response_at, threads);
  const Eigen::VectorXd variances = OutputVariances(*jacobian, spread.total);
  bands.evaluations = evaluations;
  Index next = 0;
  for (const MeasuredChannel& channel : run.channels) {
    ChannelBand band;
    for (std::size_t i = 0; i < channel.response.size(); ++i) {
      const double level = ResponseLevel(run, channel, modelled, i);
      const OctaveDiscrepancy missed = DiscrepancyAt(discrepancies, channel.name, run.excitation.frequency_Hz[i]);
      band.radial.push_back(kReach * std::sqrt(variances[next++]));
      band.tangential.push_back(kReach * std::sqrt(variances[next++]));
      band.radial_measured.push_back(
          std::hypot(band.radial.back(), missed.radial * level, kReach * channel.radial_sd[i]));
      band.tangential_measured.push_back(
          std::hypot(band.tangential.back(), missed.tangential * level, kReach * channel.tangential_sd[i]));
    }
    bands.counts.push_back(Outside(channel, modelled.channels[channel.sensor], band));
    bands.channels.push_back(std::move(band));
  }
  return bands;
}

}  // namespace fourpost
