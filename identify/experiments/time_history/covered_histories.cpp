#include "identify/experiments/time_history/covered_histories.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "analysis/signals/spectrum.h"
#include "identify/experiments/probed_vehicle.h"
#include "identify/experiments/time_history/history_simulation.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {
namespace {

/// Where the power of a speed, of heights of this spectrum, reaches a share of the whole; what noise of this density
/// may come to is no motion. NaN where all is noise.
double FrequencyAt(double share, const Spectrum& heights, double noise_density) {
  // Of one average, which is distributed exponentially, one bin of a thousand is higher.
  constexpr double kScatter = 7;
  std::vector<double> power;
  for (std::size_t i = 0; i < heights.first.size(); ++i)
    power.push_back(
        heights.first[i] > kScatter * noise_density ? std::pow(heights.frequency_Hz[i], 2) * heights.first[i] : 0);
  const double all = std::accumulate(power.begin(), power.end(), 0.0);
  if (all == 0) return std::numeric_limits<double>::quiet_NaN();
  const double wanted = share * all;
  double below = 0;
  for (std::size_t i = 0; i < power.size(); ++i)
    if ((below += power[i]) >= wanted) return heights.frequency_Hz[i];
  return heights.frequency_Hz.back();
}

/// Posts in the window.
void AddPosts(const MeasuredHistory& history, CoveredRanges& ranges) {
  constexpr double kSegment_s = 8;
  constexpr double kRest = 0.01;
  const auto count = static_cast<std::size_t>(history.count);
  const auto segment = std::min(count, static_cast<std::size_t>(kSegment_s * history.rate_Hz));
  for (std::size_t post = 0; post < history.heights.size(); ++post) {
    const std::vector<double>& heights = history.heights[post];
    if (segment < 4 || heights.size() < static_cast<std::size_t>(history.first) + count) continue;
    const std::vector<double> window(heights.begin() + history.first, heights.begin() + history.first + history.count);
    const double most = std::abs(
        *std::max_element(window.begin(), window.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
    if (most == 0) continue;
    const Spectrum spectrum = WelchSpectrum(window, window, history.rate_Hz, segment);
    const double noise = 2 * std::pow(history.post_noise_sd[post], 2) / history.rate_Hz;
    ranges.Add(CoveredQuantity::kPostFrequency, "posts", FrequencyAt(kRest, spectrum, noise),
               FrequencyAt(1 - kRest, spectrum, noise));
    ranges.Add(CoveredQuantity::kPostAmplitude, "posts", 0, most);
  }
}

}  // namespace

CoveredRanges CoveredByHistories(const Vehicle& vehicle, const std::vector<double>& values,
                                 const std::vector<MeasuredHistory>& histories, const std::vector<double>& steps_s) {
  const ProbedVehicle probed(vehicle);
  const CondensedVehicle condensed(probed.vehicle());
  const CondensedVehicle own(vehicle);
  CoveredRanges ranges;
  for (std::size_t h = 0; h < histories.size(); ++h) {
    AddPosts(histories[h], ranges);
    const std::vector<double> at = histories[h].setting.At(values);
    const CondensedModel model = condensed.At(at);
    const HistorySimulation simulation(histories[h], steps_s[h]);
    const Eigen::MatrixXd readings = simulation.Readings(model, simulation.StateOf(own.At(at)));
    probed.AddMotion(readings, histories[h].rate_Hz, model, ranges);
  }
  return ranges;
}

}  // namespace fourpost
