#include "analysis/signals/spikes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/signals/median.h"

namespace fourpost {
namespace {

constexpr std::size_t kReach = 2;

double MedianAbout(std::span<const double> signal, std::size_t k) {
  std::array<double, 2 * kReach + 1> near;
  std::copy_n(signal.begin() + static_cast<std::ptrdiff_t>(k - kReach), near.size(), near.begin());
  return Median(near);
}

}  // namespace

std::vector<std::size_t> Spikes(std::span<const double> signal) {
  if (signal.size() < 2 * kReach + 1) return {};
  std::vector<double> distances(signal.size());
  for (std::size_t k = kReach; k + kReach < signal.size(); ++k)
    distances[k] = std::abs(signal[k] - MedianAbout(signal, k));
  const auto [least, most] = std::minmax_element(signal.begin(), signal.end());
  const double limit = std::max(0.1 * (*most - *least), 12 * 1.4826 * Median(distances));
  std::vector<std::size_t> spikes;
  for (std::size_t k = 0; k < distances.size(); ++k)
    if (distances[k] > limit) spikes.push_back(k);
  return spikes;
}

}  // namespace fourpost
