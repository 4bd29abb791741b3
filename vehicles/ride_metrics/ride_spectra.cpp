#include "vehicles/ride_metrics/ride_spectra.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

#include "analysis/signals/spectrum.h"
#include "vehicles/description/post_pattern.h"

namespace fourpost {
namespace {

using Eigen::Index;

constexpr double kWelchSegment_s = 8;

/// Channels of a ride, without values, and their sensors.
std::vector<std::pair<RideSpectra::Channel, std::size_t>> ChannelsOf(const RideInstruments& instruments) {
  std::vector<std::pair<RideSpectra::Channel, std::size_t>> channels;
  for (const RideInstruments::Felt& felt : instruments.points)
    channels.push_back({{.name = felt.name, .unit = "m/s^2", .density = {}}, felt.sensor});
  for (std::size_t i = 0; i < instruments.loads.size(); ++i)
    channels.push_back({{.name = instruments.vehicle.tyres[i].name, .unit = "N", .density = {}}, instruments.loads[i]});
  return channels;
}

/// What of the chassis answers a pattern.
Eigen::RowVectorXcd Answer(const RandomResponse& response, const RideInstruments::Chassis& at,
                           std::string_view pattern) {
  const auto height = [&](std::size_t sensor) { return response.readings.row(static_cast<Index>(sensor)); };
  if (pattern == "heave") return height(at.centre);
  if (pattern == "pitch") return (height(at.centre) - height(at.ahead)) / RideInstruments::kLever_m;
  return (height(at.left) - height(at.centre)) / RideInstruments::kLever_m;
}

}  // namespace

std::vector<double> WeightedDensity(const RideSpectra& spectra, std::size_t channel, Weighting weighting) {
  const WeightingFilter filter(weighting);
  std::vector<double> density = spectra.channels[channel].density;
  for (std::size_t k = 0; k < density.size(); ++k) density[k] *= std::norm(filter.Response(spectra.frequency_Hz[k]));
  return density;
}

RideSpectra SpectraOf(const RideInstruments& instruments, const SpectralGrid& grid, const RandomResponse& response) {
  RideSpectra spectra{.frequency_Hz = grid.frequency_Hz, .channels = {}};
  const Index sources = response.readings.cols() / static_cast<Index>(grid.size());
  for (auto& [channel, sensor] : ChannelsOf(instruments)) {
    const auto row = response.readings.row(static_cast<Index>(sensor));
    for (Index k = 0; k < static_cast<Index>(grid.size()); ++k)
      channel.density.push_back(row.segment(k * sources, sources).squaredNorm());
    spectra.channels.push_back(std::move(channel));
  }
  return spectra;
}

RideSpectra SpectraOf(const RideInstruments& instruments, const TimeHistory& history, double upper_Hz) {
  RideSpectra spectra;
  const auto count = static_cast<std::size_t>(history.size());
  const std::size_t segment = std::min(count, static_cast<std::size_t>(std::lround(kWelchSegment_s * history.rate_Hz)));
  for (auto& [channel, sensor] : ChannelsOf(instruments)) {
    const std::span<const double> samples(history.readings.col(static_cast<Index>(sensor)).data(), count);
    const Spectrum spectrum = WelchSpectrum(samples, samples, history.rate_Hz, segment);
    // From the second on: the first is the mean, which is taken away.
    std::size_t end = 1;
    while (end < spectrum.frequency_Hz.size() && spectrum.frequency_Hz[end] <= upper_Hz) ++end;
    spectra.frequency_Hz.assign(spectrum.frequency_Hz.begin() + 1,
                                spectrum.frequency_Hz.begin() + static_cast<std::ptrdiff_t>(end));
    channel.density.assign(spectrum.first.begin() + 1, spectrum.first.begin() + static_cast<std::ptrdiff_t>(end));
    spectra.channels.push_back(std::move(channel));
  }
  return spectra;
}

std::vector<BodyGain> BodyGainsOf(const RideInstruments& instruments, const RandomVehicle& vehicle,
                                  const std::vector<StatisticalGain>& gains) {
  std::vector<BodyGain> answers;
  if (!instruments.chassis) return answers;
  const std::vector<double>& frequencies = vehicle.grid().frequency_Hz;
  for (const std::string_view pattern : {"heave", "pitch", "roll"}) {
    std::vector<double> shape;
    try {
      shape = PostPattern(instruments.vehicle, pattern);
    } catch (const PatternError&) {
      continue;
    }
    const Eigen::Map<const Eigen::VectorXd> column(shape.data(), static_cast<Index>(shape.size()));
    const PostSpectra unit{
        .sources = 1,
        .heights = column.replicate(1, static_cast<Index>(frequencies.size())).cast<std::complex<double>>()};
    const Eigen::RowVectorXcd answer = Answer(vehicle.Respond(unit, gains), *instruments.chassis, pattern);
    BodyGain gain{.pattern = std::string(pattern)};
    for (std::size_t k = 0; k < frequencies.size(); ++k) {
      const double size = std::abs(answer[static_cast<Index>(k)]);
      const double acceleration = size * std::pow(2 * std::numbers::pi * frequencies[k], 2);
      if (size > gain.largest) gain.at_Hz = frequencies[k];
      if (acceleration > gain.largest_acceleration) gain.acceleration_at_Hz = frequencies[k];
      gain.largest = std::max(gain.largest, size);
      gain.largest_acceleration = std::max(gain.largest_acceleration, acceleration);
    }
    // A model that does not turn this way.
    if (gain.largest > 1e-9) answers.push_back(std::move(gain));
  }
  return answers;
}

}  // namespace fourpost
