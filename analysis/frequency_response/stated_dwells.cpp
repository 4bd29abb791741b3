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

/// From one of the frequencies to the next.
double GapAt(std::size_t place, std::span<const double> stated) {
  double gap = std::numeric_limits<double>::infinity();
  if (place > 0) gap = std::min(gap, stated[place] - stated[place - 1]);
  if (place + 1 < stated.size()) gap = std::min(gap, stated[place + 1] - stated[place]);
  return gap;
}

/// The frequency that is nearest and nearer than a share of the way to the next, by its place.
std::optional<std::size_t> NearestTo(double frequency, std::span<const double> stated, double share) {
  constexpr double kAlone = 0.05;
  /// Of frequencies that are far apart.
  constexpr double kNear = 0.2;
  const auto after = std::lower_bound(stated.begin(), stated.end(), frequency);
  auto nearest = after;
  if (after == stated.end() || (after != stated.begin() && frequency - *(after - 1) < *after - frequency)) --nearest;
  const auto place = static_cast<std::size_t>(nearest - stated.begin());
  const double reach = stated.size() > 1 ? std::min(share * GapAt(place, stated), kNear * *nearest) : kAlone * *nearest;
  if (std::abs(frequency - *nearest) > reach) return std::nullopt;
  return place;
}

double MedianAmplitude(std::span<const TonePoint> points) {
  std::vector<double> amplitudes;
  for (const TonePoint& point : points) amplitudes.push_back(point.amplitude);
  const auto middle = amplitudes.begin() + static_cast<std::ptrdiff_t>(amplitudes.size() / 2);
  std::nth_element(amplitudes.begin(), middle, amplitudes.end());
  return *middle;
}

/// Stretches of the track whose phase turns by a stated frequency.
std::vector<Dwell> Stretches(std::span<const TonePoint> sharp, std::span<const double> stated) {
  constexpr double kRest = 5e-3;
  constexpr double kHalf = 0.5;
  double largest = 0;
  for (const TonePoint& point : sharp) largest = std::max(largest, point.amplitude);
  std::vector<std::optional<std::size_t>> nearest(sharp.size());
  for (std::size_t k = 0; k < sharp.size(); ++k) {
    if (sharp[k].amplitude < kRest * largest) continue;
    if (const std::optional<double> frequency = FrequencyAt(sharp, k))
      nearest[k] = NearestTo(*frequency, stated, kHalf);
  }
  std::vector<Dwell> stretches;
  for (std::size_t first = 0; first < sharp.size();) {
    std::size_t last = first;
    while (last + 1 < sharp.size() && nearest[last + 1] == nearest[first]) ++last;
    if (nearest[first])
      stretches.push_back({.start = sharp[first].time,
                           .end = sharp[last].time,
                           .cycles_per_sample = stated[*nearest[first]],
                           .amplitude = MedianAmplitude(sharp.subspan(first, last - first + 1))});
    first = last + 1;
  }
  return stretches;
}

/// Whether a dwell is longer than the stretch of its frequency by a cycle, as beside a pause, and has a cycle of no
/// other, as astride a step.
bool IsBetterThan(std::span<const Dwell> stretches, const Dwell& dwell) {
  return std::none_of(stretches.begin(), stretches.end(), [&](const Dwell& stretch) {
    const double common = std::min(dwell.end, stretch.end) - std::max(dwell.start, stretch.start);
    const bool is_other = stretch.cycles_per_sample != dwell.cycles_per_sample;
    return common > 0 && (is_other ? common * dwell.cycles_per_sample > 1 : stretch.cycles() > dwell.cycles() - 1);
  });
}

/// Of those found the ones that surely are of a stated frequency. Where the phase turns by less than a quarter of a
/// cycle from one to the next, a dwell may lie astride two.
std::vector<Dwell> Matched(std::span<const Dwell> found, std::span<const Dwell> stretches,
                           std::span<const double> stated) {
  constexpr double kSure = 0.25;
  constexpr double kApart = 0.25;
  std::vector<Dwell> matched;
  for (Dwell dwell : found) {
    const std::optional<std::size_t> place = NearestTo(dwell.cycles_per_sample, stated, kSure);
    if (!place) continue;
    dwell.cycles_per_sample = stated[*place];
    const bool is_apart = GapAt(*place, stated) * (dwell.end - dwell.start) > kApart;
    if (is_apart || IsBetterThan(stretches, dwell)) matched.push_back(dwell);
  }
  return matched;
}

/// What no other dwell has of it.
Dwell Beside(Dwell stretch, std::span<const Dwell> others) {
  for (const Dwell& other : others) {
    if (other.end <= stretch.start || stretch.end <= other.start) continue;
    const double middle = 0.5 * (stretch.start + stretch.end);
    if (middle < other.start) stretch.end = other.start;
    else if (middle > other.end) stretch.start = other.end;
    else stretch.end = stretch.start;
  }
  return stretch;
}

}  // namespace

std::vector<Dwell> DwellsOfFrequencies(std::span<const double> signal, std::span<const TonePoint> track,
                                       std::span<const Dwell> found, std::span<const double> cycles_per_sample) {
  constexpr double kFewestCycles = 1.5;
  const std::vector<Dwell> stretches = Stretches(SharpTrack(signal, track), cycles_per_sample);
  const std::vector<Dwell> matched = Matched(found, stretches, cycles_per_sample);
  std::vector<Dwell> dwells = matched;
  for (const Dwell& stretch : stretches)
    if (const Dwell dwell = Beside(stretch, matched); dwell.cycles() >= kFewestCycles) dwells.push_back(dwell);
  std::sort(dwells.begin(), dwells.end(), [](const Dwell& one, const Dwell& other) { return one.start < other.start; });
  return dwells;
}

}  // namespace fourpost
