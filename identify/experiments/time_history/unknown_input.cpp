#include "identify/experiments/time_history/unknown_input.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/files/bridged_samples.h"
#include "analysis/signals/uneven_samples.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/mode_times.h"

namespace fourpost {
namespace {

/// At each end, which interpolation looks at.
constexpr std::size_t kNeighbours = 4;

/// Sum of squares of what interpolation misses of `count` samples from `first` on.
double SquaresMissed(std::span<const double> input, std::size_t first, std::size_t count) {
  std::vector<double> times;
  std::vector<double> known;
  std::vector<double> asked;
  for (std::size_t k = first - kNeighbours; k < first + count + kNeighbours; ++k) {
    const bool is_left_out = k >= first && k < first + count;
    if (is_left_out) asked.push_back(static_cast<double>(k));
    else {
      times.push_back(static_cast<double>(k));
      known.push_back(input[k]);
    }
  }
  const std::vector<double> bridged = InterpolatedAt(times, known, asked);
  double squares = 0;
  for (std::size_t k = 0; k < count; ++k) squares += std::pow(bridged[k] - input[first + k], 2);
  return squares;
}

/// Rms at places about a gap, which none of them touches; infinite where there is no room.
double ErrorOfBridging(std::span<const double> input, std::size_t gap, std::size_t count, std::size_t reach) {
  constexpr std::size_t kPlaces = 100;
  const std::size_t from = std::max(kNeighbours, gap > reach ? gap - reach : 0);
  const std::size_t to = std::min(input.size(), gap + count + reach);
  const std::size_t apart = std::max<std::size_t>(1, (to - from) / kPlaces);
  double squares = 0;
  std::size_t samples = 0;
  for (std::size_t first = from; first + count + kNeighbours <= to; first += apart) {
    const bool touches = first < gap + count + kNeighbours && gap < first + count + kNeighbours;
    if (touches) continue;
    squares += SquaresMissed(input, first, count);
    samples += count;
  }
  return samples > 0 ? std::sqrt(squares / static_cast<double>(samples)) : std::numeric_limits<double>::infinity();
}

double SettlingTimeOf(const Vehicle& vehicle, const MeasuredHistory& history) {
  constexpr double kLongestMemory_s = 10;
  double settled_s = 0;
  for (const Mode& mode : ModesOf(CondensedVehicle(vehicle).At(history.setting.At(vehicle.ParameterValues())))) {
    const double one = SettlingTime_s(mode);
    // Also of modes without damping.
    const bool ends = one >= 0 && one < kLongestMemory_s;
    settled_s = std::max(settled_s, ends ? one : kLongestMemory_s);
  }
  return settled_s;
}

}  // namespace

std::vector<BridgedGap> VisibleGaps(const TimeRecording& recording, std::span<const double> input, double unseen,
                                    const std::vector<BridgedGap>& gaps) {
  constexpr double kReach_s = 2;
  constexpr double kReachGaps = 25;
  std::vector<BridgedGap> visible;
  for (const BridgedGap& gap : gaps) {
    const auto before = std::lround((gap.from_s - recording.start_s) / recording.step_s);
    const auto behind = std::lround((gap.to_s - recording.start_s) / recording.step_s);
    if (behind - before < 2) continue;
    const bool is_at_end = before < 0 || behind >= std::ssize(input);
    const auto count = static_cast<std::size_t>(behind - before - 1);
    const double reach = std::max(kReach_s / recording.step_s, kReachGaps * static_cast<double>(count));
    if (is_at_end ||
        ErrorOfBridging(input, static_cast<std::size_t>(before + 1), count, static_cast<std::size_t>(reach)) > unseen)
      visible.push_back(gap);
  }
  return visible;
}

UnknownMotion LeaveOutMotion(const Vehicle& vehicle, std::vector<BridgedGap> gaps, MeasuredHistory& history) {
  UnknownMotion unknown{.settled_s = SettlingTimeOf(vehicle, history)};
  // Samples between times, of the window.
  const auto sample = [&](double t) { return (t - history.TimeAt(0)) * history.rate_Hz; };
  constexpr double kRounding = 1e-6;
  Eigen::Index next = 0;
  for (const BridgedGap& gap : MergedGaps(std::move(gaps))) {
    const auto first = std::max(next, static_cast<Eigen::Index>(std::floor(sample(gap.from_s) + kRounding)) + 1);
    const auto end =
        std::min(history.count, static_cast<Eigen::Index>(std::ceil(sample(gap.to_s + unknown.settled_s) - kRounding)));
    if (end <= first) continue;
    unknown.gaps.push_back(gap);
    unknown.samples += end - first;
    for (MeasuredSignal& signal : history.signals)
      for (Eigen::Index k = first; k < end; ++k) signal.LeaveOut(k);
    next = end;
  }
  return unknown;
}

}  // namespace fourpost
