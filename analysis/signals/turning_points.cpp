#include "analysis/signals/turning_points.h"

#include <algorithm>
#include <cmath>

namespace fourpost {

std::vector<std::size_t> TurningPoints(std::span<const double> signal) {
  std::vector<std::size_t> turns;
  if (signal.empty()) return turns;
  const auto [least, most] = std::minmax_element(signal.begin(), signal.end());
  double enough = 0.05 * (*most - *least);
  std::size_t high = 0;
  std::size_t low = 0;
  int going = 0;
  const auto turn_at = [&](std::size_t extreme) {
    if (!turns.empty()) enough = 0.2 * std::abs(signal[extreme] - signal[turns.back()]);
    turns.push_back(extreme);
  };
  for (std::size_t k = 1; k < signal.size(); ++k) {
    if (signal[k] > signal[high]) high = k;
    if (signal[k] < signal[low]) low = k;
    if (going >= 0 && signal[high] - signal[k] > enough) {
      if (going > 0) turn_at(high);
      going = -1;
      low = k;
    } else if (going <= 0 && signal[k] - signal[low] > enough) {
      if (going < 0) turn_at(low);
      going = 1;
      high = k;
    }
  }
  return turns;
}

}  // namespace fourpost
