#include "identify/draft/motion_evidence.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "identify/experiments/four_post/modelled_response.h"
#include "vehicles/description/post_pattern.h"

namespace fourpost {
namespace {

/// Real part of the correlation of complex responses; NaN where one of them is zero.
double Correlation(const ChannelResponse& one, const ChannelResponse& other) {
  double product = 0;
  double first = 0;
  double second = 0;
  for (std::size_t i = 0; i < one.response.size(); ++i) {
    if (!std::isfinite(one.response[i].real()) || !std::isfinite(other.response[i].real())) continue;
    product += (std::conj(one.response[i]) * other.response[i]).real();
    first += std::norm(one.response[i]);
    second += std::norm(other.response[i]);
  }
  return product / std::sqrt(first * second);
}

/// At no more frequencies than show how a channel moves, within those that the values of a car which is not fitted get
/// about right.
FrequencyResponse Thinned(const FrequencyResponse& response) {
  constexpr std::size_t kMost = 16;
  constexpr double kHighest_Hz = 12;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < response.frequency_Hz.size(); ++i)
    if (response.frequency_Hz[i] <= kHighest_Hz) kept.push_back(i);
  const std::size_t step = std::max<std::size_t>(1, kept.size() / kMost);
  FrequencyResponse thin;
  for (const ChannelResponse& channel : response.channels) thin.channels.push_back({channel.name, channel.unit});
  for (std::size_t k = 0; k < kept.size(); k += step) {
    thin.frequency_Hz.push_back(response.frequency_Hz[kept[k]]);
    thin.amplitude_m.push_back(response.amplitude_m[kept[k]]);
    for (std::size_t c = 0; c < thin.channels.size(); ++c)
      thin.channels[c].response.push_back(response.channels[c].response[kept[k]]);
  }
  return thin;
}

}  // namespace

FrequencyResponse MotionEvidence::Modelled(const DraftedMotion& motion, const std::vector<double>& shape) const {
  MeasuredRun run;
  run.excitation = {
      .frequency_Hz = motion.response.frequency_Hz, .amplitude_m = motion.response.amplitude_m, .shape = shape};
  return ModelledResponses(*model_, vehicle_.sensors, {run}).front();
}

std::vector<double> MotionEvidence::LikeliestShape(const FileReading& reading, const DraftedMotion& motion) const {
  const std::vector<ChannelMatch> named = MatchChannels(SoughtSensors(vehicle_), reading.channels, HasSides(vehicle_));
  std::vector<double> best;
  double most = 0;
  for (const std::string_view pattern : kPostPatterns) {
    std::vector<double> shape;
    try {
      shape = PostPattern(vehicle_, pattern);
    } catch (const PatternError&) {
      continue;
    }
    const FrequencyResponse modelled = Modelled(motion, shape);
    double sum = 0;
    for (const ChannelMatch& match : named)
      for (const SourceChannel& source : match.source.channels) {
        const double correlation = Correlation(*modelled.Find(match.name), *motion.response.Find(source.name));
        if (std::isfinite(correlation)) sum += correlation;
      }
    if (!(sum > most)) continue;
    most = sum;
    best = shape;
  }
  return best;
}

void MotionEvidence::Add(FileReading& reading) {
  if (model_ == nullptr) return;
  for (DraftedMotion& motion : reading.motions) {
    const DraftedMotion thin{Thinned(motion.response), {}};
    if (thin.response.frequency_Hz.empty()) continue;
    if (motion.shape.empty()) motion.shape = LikeliestShape(reading, thin);
    if (motion.shape.empty()) continue;
    const FrequencyResponse modelled = Modelled(thin, motion.shape);
    for (const ChannelResponse& sensor : modelled.channels)
      for (const ChannelResponse& channel : thin.response.channels) {
        if (sensor.unit != channel.unit) continue;
        const double correlation = Correlation(sensor, channel);
        if (!std::isfinite(correlation)) continue;
        Sum& sum = sums_[{sensor.name, channel.name}];
        sum.correlations += correlation;
        ++sum.count;
      }
  }
}

std::optional<double> MotionEvidence::Of(const std::string& sensor, const std::string& channel) const {
  const auto found = sums_.find({sensor, channel});
  if (found == sums_.end()) return std::nullopt;
  return found->second.correlations / found->second.count;
}

}  // namespace fourpost
