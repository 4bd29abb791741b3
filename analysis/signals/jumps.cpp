#include "analysis/signals/jumps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/signals/median.h"
#include "analysis/signals/spikes.h"

namespace fourpost {
namespace {

/// The two steps before step k and the two after it.
std::array<double, 4> StepsAbout(std::span<const double> steps, std::size_t k) {
  return {steps[k - 2], steps[k - 1], steps[k + 1], steps[k + 2]};
}

/// By which the steps before, and those behind, differ from each other.
double Unrest(const std::array<double, 4>& steps) {
  return std::max(std::abs(steps[1] - steps[0]), std::abs(steps[3] - steps[2]));
}

/// The ninth of ten steps in size.
double Fastest(std::vector<double> steps) {
  for (double& step : steps) step = std::abs(step);
  const auto ninth = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() * 9 / 10);
  std::nth_element(steps.begin(), ninth, steps.end());
  return *ninth;
}

}  // namespace

std::vector<std::size_t> Jumps(std::span<const double> signal) {
  // The greatest distance was 0.08 of it in the shipped bench recordings, 1.4 in sweeps down to six samples a cycle and
  // 3.2 in white noise; 18 where 4 % of a cycle was missing.
  constexpr double kOfFastest = 8;
  // White noise reached 4; sweeps, of which most is slow, 29: the other two hold them.
  constexpr double kDeviations = 12 * 1.4826;
  // Smooth signals reached 1.1; noise 27, which the other two hold.
  constexpr double kOfUnrest = 5;
  if (signal.size() < 6) return {};
  std::vector<double> steps(signal.size() - 1);
  for (std::size_t k = 0; k < steps.size(); ++k) steps[k] = signal[k + 1] - signal[k];
  std::vector<double> distances(steps.size());
  for (std::size_t k = 2; k + 2 < steps.size(); ++k) distances[k] = std::abs(steps[k] - Median(StepsAbout(steps, k)));
  const double limit = std::max(kOfFastest * Fastest(steps), kDeviations * Median(distances));
  const std::vector<std::size_t> spikes = Spikes(signal);
  const auto is_spike = [&](std::size_t k) { return std::binary_search(spikes.begin(), spikes.end(), k); };
  std::vector<std::size_t> jumps;
  for (std::size_t k = 2; k + 2 < steps.size(); ++k)
    if (distances[k] > limit && distances[k] > kOfUnrest * Unrest(StepsAbout(steps, k)) && !is_spike(k) &&
        !is_spike(k + 1))
      jumps.push_back(k);
  return jumps;
}

}  // namespace fourpost
