#include "analysis/frequency_response/stated_dwells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>

#include "analysis/frequency_response/phase_line.h"

namespace fourpost {
namespace {

/// Of points of a sharp track, which are a quarter of a cycle apart.
constexpr std::size_t kReach = 4;

/// By the phase's slope over two cycles; nothing where there is no tone so long.
std::optional<double> FrequencyAt(std::span<const TonePoint> track, std::size_t index) {
  constexpr double kTone = 0.8;
  if (index < kReach || index + kReach >= track.size()) return std::nullopt;
  PhaseLine line(track[index].time);
  double phase = 0;
  for (std::size_t k = index - kReach; k <= index + kReach; ++k) {
    const TonePoint& point = track[k];
    if (point.share < kTone) return std::nullopt;
    if (k == index - kReach) {
      phase = point.phase_rad;
    } else {
      const TonePoint& before = track[k - 1];
      const double turn =
          std::numbers::pi * (before.cycles_per_sample + point.cycles_per_sample) * (point.time - before.time);
      phase = Unwrapped(point.phase_rad, phase + turn);
    }
    line.Add(point.time, phase);
  }
  return line.slope() / (2 * std::numbers::pi);
}

/// The frequency that is nearest and near enough, by its place.
std::optional<std::size_t> NearestTo(double frequency, std::span<const double> stated) {
  constexpr double kAlone = 0.05;
  constexpr double kHalf = 0.5;
  /// Of frequencies that are far apart.
  constexpr double kNear = 0.2;
  const auto after = std::lower_bound(stated.begin(), stated.end(), frequency);
  auto nearest = after;
  if (after == stated.end() || (after != stated.begin() && frequency - *(after - 1) < *after - frequency)) --nearest;
  double gap = std::numeric_limits<double>::infinity();
  if (nearest != stated.begin()) gap = std::min(gap, *nearest - *(nearest - 1));
  if (nearest + 1 != stated.end()) gap = std::min(gap, *(nearest + 1) - *nearest);
  const double reach = stated.size() > 1 ? std::min(kHalf * gap, kNear * *nearest) : kAlone * *nearest;
  if (std::abs(frequency - *nearest) > reach) return std::nullopt;
  return static_cast<std::size_t>(nearest - stated.begin());
}

double MedianAmplitude(std::span<const TonePoint> points) {
  std::vector<double> amplitudes;
  for (const TonePoint& point : points) amplitudes.push_back(point.amplitude);
  const auto middle = amplitudes.begin() + static_cast<std::ptrdiff_t>(amplitudes.size() / 2);
  std::nth_element(amplitudes.begin(), middle, amplitudes.end());
  return *middle;
}

}  // namespace

std::vector<Dwell> DwellsOfFrequencies(std::span<const double> signal, std::span<const TonePoint> track,
                                       std::span<const double> cycles_per_sample) {
  constexpr double kFewestCycles = 1.5;
  constexpr double kRest = 5e-3;
  const std::vector<TonePoint> sharp = SharpTrack(signal, track);
  double largest = 0;
  for (const TonePoint& point : sharp) largest = std::max(largest, point.amplitude);
  std::vector<std::optional<std::size_t>> nearest(sharp.size());
  for (std::size_t k = 0; k < sharp.size(); ++k) {
    if (sharp[k].amplitude < kRest * largest) continue;
    if (const std::optional<double> frequency = FrequencyAt(sharp, k))
      nearest[k] = NearestTo(*frequency, cycles_per_sample);
  }
  std::vector<Dwell> dwells;
  for (std::size_t first = 0; first < sharp.size();) {
    std::size_t last = first;
    while (last + 1 < sharp.size() && nearest[last + 1] == nearest[first]) ++last;
    if (nearest[first]) {
      const Dwell dwell{.start = sharp[first].time,
                        .end = sharp[last].time,
                        .cycles_per_sample = cycles_per_sample[*nearest[first]],
                        .amplitude = MedianAmplitude(std::span(sharp).subspan(first, last - first + 1))};
      if (dwell.cycles() >= kFewestCycles) dwells.push_back(dwell);
    }
    first = last + 1;
  }
  return dwells;
}

}  // namespace fourpost
