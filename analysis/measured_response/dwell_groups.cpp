#include "analysis/measured_response/dwell_groups.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace fourpost {
namespace {

bool HaveOneFrequency(const DwellResponse& one, const DwellResponse& other) {
  constexpr double kCycles = 0.3;
  constexpr double kMost = 3e-3;
  const double fewest = std::min(one.cycles, other.cycles);
  return std::abs(one.frequency_Hz / other.frequency_Hz - 1) < std::min(kMost, kCycles / fewest);
}

bool HaveOneAmplitude(const DwellResponse& one, const DwellResponse& other) {
  constexpr double kChange = 0.1;
  return std::abs(one.amplitude / other.amplitude - 1) < kChange;
}

/// Whether the group has room for the dwell, which it then has taken.
bool Takes(DwellGroup& group, const DwellResponse& dwell) {
  if (!(group.shares == dwell.shares)) return false;
  for (std::vector<DwellResponse>& repeats : group.frequencies) {
    if (!HaveOneFrequency(repeats.front(), dwell)) continue;
    if (!HaveOneAmplitude(repeats.front(), dwell)) return false;
    repeats.push_back(dwell);
    return true;
  }
  group.frequencies.push_back({dwell});
  return true;
}

/// Variance of the mean of what repeats say, by its scatter.
template <typename Value>
double Spread(std::span<const DwellResponse> repeats, Value value, std::complex<double> mean) {
  const double n = static_cast<double>(repeats.size());
  double sum = 0;
  for (const DwellResponse& repeat : repeats) sum += std::norm(value(repeat) - mean);
  return repeats.size() > 1 ? sum / (n - 1) / n : 0;
}

/// The mean offset, over the repeats of recordings that begin at rest.
void AverageMean(std::span<const DwellResponse> repeats, std::size_t c, DwellChannel& channel) {
  std::vector<DwellResponse> from_rest;
  for (const DwellResponse& repeat : repeats)
    if (!std::isnan(repeat.channels[c].mean)) from_rest.push_back(repeat);
  if (from_rest.empty()) return;
  const double n = static_cast<double>(from_rest.size());
  const auto mean_of = [c](const DwellResponse& repeat) { return repeat.channels[c].mean; };
  double mean = 0;
  double variance = 0;
  for (const DwellResponse& repeat : from_rest) {
    mean += mean_of(repeat) / n;
    // What transients leave is the same in every repeat.
    variance += repeat.channels[c].mean_variance / n;
  }
  channel.mean = mean;
  channel.mean_variance = std::max(variance, Spread(from_rest, mean_of, mean));
}

}  // namespace

std::vector<DwellGroup> GroupsOf(std::span<const DwellResponse> dwells) {
  std::vector<DwellGroup> groups;
  for (const DwellResponse& dwell : dwells) {
    const bool is_taken =
        std::any_of(groups.begin(), groups.end(), [&](DwellGroup& group) { return Takes(group, dwell); });
    if (!is_taken) groups.push_back({dwell.shares, {{dwell}}});
  }
  for (DwellGroup& group : groups)
    std::sort(group.frequencies.begin(), group.frequencies.end(),
              [](const auto& a, const auto& b) { return a.front().frequency_Hz < b.front().frequency_Hz; });
  return groups;
}

DwellResponse MeanOf(std::span<const DwellResponse> repeats) {
  DwellResponse mean = repeats.front();
  const double n = static_cast<double>(repeats.size());
  const auto average = [&](auto value) {
    auto sum = value(repeats.front());
    for (std::size_t r = 1; r < repeats.size(); ++r) sum += value(repeats[r]);
    return sum / n;
  };
  mean.frequency_Hz = average([](const DwellResponse& repeat) { return repeat.frequency_Hz; });
  mean.amplitude = average([](const DwellResponse& repeat) { return repeat.amplitude; });
  mean.post_distortion = average([](const DwellResponse& repeat) { return repeat.post_distortion; });
  mean.shares.rest = average([](const DwellResponse& repeat) { return repeat.shares.rest; });
  for (std::size_t c = 0; c < mean.channels.size(); ++c) {
    DwellChannel& channel = mean.channels[c];
    const auto response_of = [c](const DwellResponse& repeat) { return repeat.channels[c].response; };
    channel.response = average(response_of);
    for (std::size_t h = 0; h < channel.harmonics.size(); ++h)
      channel.harmonics[h] = average([&](const DwellResponse& repeat) { return repeat.channels[c].harmonics[h]; });
    const double within = average([c](const DwellResponse& repeat) { return repeat.channels[c].variance; }) / n;
    channel.variance = std::max(within, Spread(repeats, response_of, channel.response));
    AverageMean(repeats, c, channel);
  }
  return mean;
}

}  // namespace fourpost
