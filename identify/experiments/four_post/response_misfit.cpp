#include "identify/experiments/four_post/response_misfit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/signals/decibel.h"
#include "identify/experiments/four_post/four_post_residuals.h"

namespace fourpost {
namespace {

struct Sums {
  double square_dB = 0;
  double square_deg = 0;
  double square_error = 0;
  double square_measured = 0;
  double square_scatter = 0;
  double count = 0;
  /// Of relative errors: their squares, and products of neighbours.
  double square_relative = 0;
  double product = 0;

  double NeighbourCorrelation() const { return square_relative > 0 ? product / square_relative : 0; }
};

void Add(const MeasuredChannel& measured, const ChannelResponse& modelled, Sums& sums) {
  std::complex<double> last = 0;
  for (std::size_t i = 0; i < measured.response.size(); ++i) {
    if (!std::isfinite(std::abs(modelled.response[i]))) continue;
    const std::complex<double> ratio = modelled.response[i] / measured.response[i];
    const double dB = DecibelFromGain(std::abs(ratio));
    const double deg = DegreesFromRadians(std::arg(ratio));
    sums.square_dB += dB * dB;
    sums.square_deg += deg * deg;
    sums.square_error += std::norm(modelled.response[i] - measured.response[i]);
    sums.square_measured += std::norm(measured.response[i]);
    if (!measured.radial_sd.empty())
      sums.square_scatter += std::pow(measured.radial_sd[i], 2) + std::pow(measured.tangential_sd[i], 2);
    sums.count += 1;
    const std::complex<double> relative = ratio - 1.0;
    sums.square_relative += std::norm(relative);
    sums.product += std::real(relative * std::conj(last));
    last = relative;
  }
}

const MeasuredChannel* Find(const MeasuredRun& run, const std::string& channel) {
  const auto found = std::find_if(run.channels.begin(), run.channels.end(),
                                  [&](const MeasuredChannel& other) { return other.name == channel; });
  return found == run.channels.end() ? nullptr : &*found;
}

/// Of a channel at one frequency, in all recordings of one pattern.
std::vector<std::complex<double>> Alike(const std::vector<MeasuredRun>& runs, const MeasuredRun& first,
                                        std::size_t frequency, const std::string& channel) {
  constexpr double kSame = 1e-3;
  const double wanted_Hz = first.excitation.frequency_Hz[frequency];
  std::vector<std::complex<double>> alike;
  for (const MeasuredRun& run : runs) {
    const MeasuredChannel* measured = Find(run, channel);
    if (!measured || run.excitation.shape != first.excitation.shape) continue;
    for (std::size_t i = 0; i < run.excitation.frequency_Hz.size(); ++i)
      if (std::abs(run.excitation.frequency_Hz[i] - wanted_Hz) < kSame * wanted_Hz)
        alike.push_back(measured->response[i]);
  }
  return alike;
}

/// What the mean over recordings leaves of each; nothing where no frequency is shared.
std::optional<double> LinearError_percent(const std::vector<MeasuredRun>& runs, const std::string& channel) {
  double error = 0;
  double all = 0;
  for (const MeasuredRun& run : runs) {
    const MeasuredChannel* measured = Find(run, channel);
    for (std::size_t i = 0; measured && i < run.excitation.frequency_Hz.size(); ++i) {
      const std::vector<std::complex<double>> alike = Alike(runs, run, i, channel);
      if (alike.size() < 2) continue;
      std::complex<double> mean = 0;
      for (const std::complex<double>& one : alike) mean += one / static_cast<double>(alike.size());
      error += std::norm(measured->response[i] - mean);
      all += std::norm(measured->response[i]);
    }
  }
  return all > 0 ? std::optional(100 * error / all) : std::nullopt;
}

}  // namespace

std::optional<double> ChannelMisfit::Allowed_percent() const {
  if (scatter_percent && linear_percent) return std::min(*scatter_percent, *linear_percent);
  return scatter_percent ? scatter_percent : linear_percent;
}

std::vector<ChannelMisfit> ResponseMisfits(const std::vector<MeasuredRun>& runs,
                                           const std::vector<FrequencyResponse>& modelled) {
  std::vector<ChannelMisfit> misfits;
  std::vector<Sums> sums;
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (const MeasuredChannel& channel : runs[r].channels) {
      const auto known = std::find_if(misfits.begin(), misfits.end(),
                                      [&](const ChannelMisfit& misfit) { return misfit.name == channel.name; });
      const auto index = static_cast<std::size_t>(known - misfits.begin());
      if (known == misfits.end()) {
        misfits.push_back({channel.name});
        sums.emplace_back();
      }
      Add(channel, modelled[r].channels[channel.sensor], sums[index]);
    }
  for (std::size_t i = 0; i < misfits.size(); ++i) {
    misfits[i].rms_dB = std::sqrt(sums[i].square_dB / sums[i].count);
    misfits[i].rms_deg = std::sqrt(sums[i].square_deg / sums[i].count);
    misfits[i].nmse_percent = 100 * sums[i].square_error / sums[i].square_measured;
    if (sums[i].square_scatter > 0) misfits[i].scatter_percent = 100 * sums[i].square_scatter / sums[i].square_measured;
    misfits[i].linear_percent = LinearError_percent(runs, misfits[i].name);
    misfits[i].residual_correlation = sums[i].NeighbourCorrelation();
  }
  return misfits;
}

void AddDeviations(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled,
                   const ModelError& model_error, std::vector<ChannelMisfit>& misfits) {
  for (ChannelMisfit& misfit : misfits) {
    double squares = 0;
    double count = 0;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const MeasuredChannel* const channel = Find(runs[r], misfit.name);
      if (channel == nullptr) continue;
      const auto place = static_cast<std::size_t>(channel - runs[r].channels.data());
      const double off = ResponseDeviations(runs[r], modelled[r], model_error)[place];
      const auto frequencies = static_cast<double>(channel->response.size());
      if (!std::isfinite(off)) continue;
      squares += frequencies * off * off;
      count += frequencies;
    }
    if (count > 0) misfit.misfit = std::sqrt(squares / count);
  }
}

std::vector<ChannelMisfit> RecordingMisfits(const std::vector<MeasuredRun>& runs,
                                            const std::vector<FrequencyResponse>& modelled) {
  std::vector<ChannelMisfit> misfits;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    Sums all;
    std::map<std::string, Sums> units;
    for (const MeasuredChannel& channel : runs[r].channels) {
      Add(channel, modelled[r].channels[channel.sensor], all);
      Add(channel, modelled[r].channels[channel.sensor], units[channel.unit]);
    }
    ChannelMisfit misfit{runs[r].name, std::sqrt(all.square_dB / all.count), std::sqrt(all.square_deg / all.count)};
    for (const auto& [unit, sums] : units)
      misfit.nmse_percent += 100 * sums.square_error / sums.square_measured / static_cast<double>(units.size());
    misfits.push_back(misfit);
  }
  return misfits;
}

std::vector<ErrorShare> ErrorShares(const std::vector<MeasuredRun>& runs,
                                    const std::vector<FrequencyResponse>& modelled) {
  std::vector<ErrorShare> shares;
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (const MeasuredChannel& channel : runs[r].channels) {
      Sums sums;
      Add(channel, modelled[r].channels[channel.sensor], sums);
      shares.push_back({.channel = channel.name,
                        .recording = runs[r].name,
                        .kind = "gain of " + channel.unit,
                        .unit = channel.unit,
                        .has_nodes = true,
                        .error = sums.square_error,
                        .measured = sums.square_measured});
    }
  return shares;
}

ChannelMisfit GroupMisfit(const std::vector<ChannelMisfit>& channels, const std::string& prefix) {
  Sums sums;
  double nmse_percent = 0;
  for (const ChannelMisfit& channel : channels) {
    if (!channel.name.starts_with(prefix)) continue;
    sums.square_dB += channel.rms_dB * channel.rms_dB;
    sums.square_deg += channel.rms_deg * channel.rms_deg;
    nmse_percent += channel.nmse_percent;
    sums.count += 1;
  }
  return {prefix, std::sqrt(sums.square_dB / sums.count), std::sqrt(sums.square_deg / sums.count),
          nmse_percent / sums.count};
}

}  // namespace fourpost
