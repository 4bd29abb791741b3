#include "analysis/signals/uneven_samples.h"

#include <algorithm>
#include <cstddef>

#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

/// At each sample of the parabola through it and its neighbours.
std::vector<double> Slopes(std::span<const double> times, std::span<const double> values) {
  const std::size_t n = times.size();
  const auto secant = [&](std::size_t k) { return (values[k + 1] - values[k]) / (times[k + 1] - times[k]); };
  std::vector<double> slopes(n);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double before = times[k] - times[k - 1];
    const double behind = times[k + 1] - times[k];
    slopes[k] = (behind * secant(k - 1) + before * secant(k)) / (before + behind);
  }
  slopes[0] = 2 * secant(0) - slopes[1];
  slopes[n - 1] = 2 * secant(n - 2) - slopes[n - 2];
  return slopes;
}

/// Of each sample but the last: whether the signal stands between it and the next one, within at least four equal
/// samples. A cubic would round the corners of a clipped signal off, by which it is known.
std::vector<bool> StandsBehind(std::span<const double> values) {
  constexpr std::size_t kFewestStanding = 4;
  std::vector<bool> stands(values.size() - 1, false);
  for (std::size_t k = 0, end = 0; k < values.size(); k = end) {
    while (end < values.size() && values[end] == values[k]) ++end;
    if (end - k >= kFewestStanding) std::fill_n(stands.begin() + static_cast<std::ptrdiff_t>(k), end - k - 1, true);
    if (end == k) ++end;  // NaN equals nothing
  }
  return stands;
}

}  // namespace

std::vector<double> InterpolatedAt(std::span<const double> times, std::span<const double> values,
                                   std::span<const double> at) {
  RequireOption(times.size() >= 3 && values.size() == times.size(), "InterpolatedAt: samples", times.size(),
                "3 at least, each with a time");
  for (std::size_t k = 1; k < times.size(); ++k)
    RequireOption(times[k] > times[k - 1], "InterpolatedAt: times", times[k], "above the one before");
  const std::vector<double> slopes = Slopes(times, values);
  const std::vector<bool> stands = StandsBehind(values);
  std::vector<double> interpolated;
  interpolated.reserve(at.size());
  std::size_t k = 0;
  for (const double time : at) {
    if (time < times[k]) k = 0;
    while (k + 2 < times.size() && times[k + 1] < time) ++k;
    if (stands[k] && time >= times[k] && time <= times[k + 1]) {
      interpolated.push_back(values[k]);
      continue;
    }
    const double width = times[k + 1] - times[k];
    const double u = (time - times[k]) / width;
    const double v = 1 - u;
    interpolated.push_back(v * v * ((1 + 2 * u) * values[k] + u * width * slopes[k]) +
                           u * u * ((1 + 2 * v) * values[k + 1] - v * width * slopes[k + 1]));
  }
  return interpolated;
}

}  // namespace fourpost
