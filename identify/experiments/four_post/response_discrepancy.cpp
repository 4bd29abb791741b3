#include "identify/experiments/four_post/response_discrepancy.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/signals/median.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNormal95 = 1.959963984540054;

double OctaveBelow(double frequency_Hz) { return std::exp2(std::floor(std::log2(frequency_Hz) + 1e-9)); }

/// Errors of one channel in one octave, and variances of their scatter, as shares of the level.
struct OctaveErrors {
  std::vector<double> radial;
  std::vector<double> tangential;
  std::vector<double> radial_scatter;
  std::vector<double> tangential_scatter;
};

/// That which 95 of 100 new ones stay below, estimated from these few.
double Reach95(std::vector<double> sizes, std::vector<double> scatter) {
  constexpr double kShare = 0.95;
  std::sort(sizes.begin(), sizes.end());
  const auto place = static_cast<std::size_t>(std::ceil(kShare * static_cast<double>(sizes.size() + 1))) - 1;
  const double reach = sizes[std::min(place, sizes.size() - 1)];
  return std::sqrt(std::max(0.0, reach * reach - kNormal95 * kNormal95 * Median(std::move(scatter))));
}

double Distance(double lower_Hz, double frequency_Hz) {
  return std::abs(std::log2(lower_Hz) - std::log2(OctaveBelow(frequency_Hz)));
}

}  // namespace

double ResponseLevel(const MeasuredRun& run, const MeasuredChannel& channel, const FrequencyResponse& modelled,
                     std::size_t frequency) {
  constexpr double kFloor = 0.03;
  double loudest = 0;
  for (const MeasuredChannel& other : run.channels) {
    const double gain = std::abs(modelled.channels[other.sensor].response[frequency]);
    if (other.unit == channel.unit && std::isfinite(gain)) loudest = std::max(loudest, gain);
  }
  return std::hypot(std::abs(modelled.channels[channel.sensor].response[frequency]), kFloor * loudest);
}

std::vector<OctaveDiscrepancy> ResponseDiscrepancies(const std::vector<MeasuredRun>& runs,
                                                     const std::vector<FrequencyResponse>& modelled) {
  std::map<std::pair<std::string, double>, OctaveErrors> errors;
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (const MeasuredChannel& channel : runs[r].channels)
      for (std::size_t i = 0; i < channel.response.size(); ++i) {
        const std::complex<double> model = modelled[r].channels[channel.sensor].response[i];
        const double level = ResponseLevel(runs[r], channel, modelled[r], i);
        if (!std::isfinite(std::abs(model)) || !(level > 0)) continue;
        const std::complex<double> turn = std::abs(model) > 0 ? std::conj(model) / std::abs(model) : 1.0;
        const std::complex<double> error = (channel.response[i] - model) * turn / level;
        OctaveErrors& octave = errors[{channel.name, OctaveBelow(runs[r].excitation.frequency_Hz[i])}];
        octave.radial.push_back(std::abs(error.real()));
        octave.tangential.push_back(std::abs(error.imag()));
        octave.radial_scatter.push_back(std::pow(channel.radial_sd[i] / level, 2));
        octave.tangential_scatter.push_back(std::pow(channel.tangential_sd[i] / level, 2));
      }
  std::vector<OctaveDiscrepancy> all;
  for (const auto& [place, octave] : errors)
    all.push_back({.channel = place.first,
                   .lower_Hz = place.second,
                   .radial = Reach95(octave.radial, octave.radial_scatter),
                   .tangential = Reach95(octave.tangential, octave.tangential_scatter)});
  return all;
}

OctaveDiscrepancy DiscrepancyAt(const std::vector<OctaveDiscrepancy>& all, const std::string& channel,
                                double frequency_Hz) {
  const auto is_known = [&](const OctaveDiscrepancy& one) { return one.channel == channel; };
  const bool has_channel = std::any_of(all.begin(), all.end(), is_known);
  double nearest = std::numeric_limits<double>::infinity();
  for (const OctaveDiscrepancy& one : all)
    if (!has_channel || is_known(one)) nearest = std::min(nearest, Distance(one.lower_Hz, frequency_Hz));
  std::vector<double> radial;
  std::vector<double> tangential;
  for (const OctaveDiscrepancy& one : all) {
    if ((has_channel && !is_known(one)) || Distance(one.lower_Hz, frequency_Hz) > nearest) continue;
    radial.push_back(one.radial);
    tangential.push_back(one.tangential);
  }
  if (radial.empty()) return {.channel = channel, .lower_Hz = OctaveBelow(frequency_Hz)};
  return {.channel = channel,
          .lower_Hz = OctaveBelow(frequency_Hz),
          .radial = Median(std::move(radial)),
          .tangential = Median(std::move(tangential))};
}

Json DiscrepancyJson(const std::vector<OctaveDiscrepancy>& all) {
  Json list = Json::array();
  for (const OctaveDiscrepancy& one : all)
    list.push_back({{"channel", one.channel},
                    {"octave_Hz", {one.lower_Hz, 2 * one.lower_Hz}},
                    {"radial", one.radial},
                    {"tangential", one.tangential}});
  return list;
}

std::vector<OctaveDiscrepancy> ReadDiscrepancies(const std::filesystem::path& result) {
  std::vector<OctaveDiscrepancy> all;
  for (const nlohmann::json& entry : ListAt(ReadResultFile(result), "discrepancy")) {
    const std::vector<nlohmann::json> octave = ListAt(entry, "octave_Hz");
    if (octave.empty() || !octave.front().is_number() || !(octave.front().get<double>() > 0)) continue;
    all.push_back({.channel = TextAt(entry, "channel"),
                   .lower_Hz = octave.front(),
                   .radial = NumberAt(entry, "radial"),
                   .tangential = NumberAt(entry, "tangential")});
  }
  return all;
}

}  // namespace fourpost
