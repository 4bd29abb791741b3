#include "identify/experiments/time_history/unknown_input.h"

#include <algorithm>
#include <cmath>

#include "analysis/signals/deviation.h"
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

/// Rms at places spread over the record; of one that is too short, the input's own.
double ErrorOfBridging(std::span<const double> input, std::size_t count) {
  constexpr std::size_t kPlaces = 100;
  if (input.size() < 2 * (count + 2 * kNeighbours)) return DeviationOf(input);
  const std::size_t last = input.size() - count - kNeighbours;
  const std::size_t apart = std::max<std::size_t>(1, (last - kNeighbours) / kPlaces);
  double squares = 0;
  std::size_t samples = 0;
  for (std::size_t first = kNeighbours; first <= last; first += apart, samples += count)
    squares += SquaresMissed(input, first, count);
  return std::sqrt(squares / static_cast<double>(samples));
}

}  // namespace

std::vector<BridgedGap> VisibleGaps(const TimeRecording& recording, std::span<const double> input, double noise_sd,
                                    const std::vector<BridgedGap>& gaps) {
  constexpr double kDeviations = 3;
  constexpr double kShare = 0.01;
  const double unseen = std::max(kDeviations * noise_sd, kShare * DeviationOf(input));
  std::vector<BridgedGap> visible;
  for (const BridgedGap& gap : gaps) {
    const long samples = std::lround((gap.to_s - gap.from_s) / recording.step_s) - 1;
    if (samples > 0 && ErrorOfBridging(input, static_cast<std::size_t>(samples)) > unseen) visible.push_back(gap);
  }
  return visible;
}

double LeaveOutMotion(const Vehicle& vehicle, const std::vector<BridgedGap>& gaps, MeasuredHistory& history) {
  constexpr double kLongest_s = 10;
  const CondensedModel model = CondensedVehicle(vehicle).At(history.setting.At(vehicle.ParameterValues()));
  double settled_s = 0;
  for (const Mode& mode : ModesOf(model))
    if (const double one = SettlingTime_s(mode); one > settled_s) settled_s = std::min(one, kLongest_s);
  const double rounding_s = 1e-6 / history.rate_Hz;
  for (MeasuredSignal& signal : history.signals)
    for (Eigen::Index k = 0; k < history.count; ++k) {
      const auto is_hidden = [&, t = history.TimeAt(k)](const BridgedGap& gap) {
        return t > gap.from_s + rounding_s && t < gap.to_s + settled_s;
      };
      if (std::any_of(gaps.begin(), gaps.end(), is_hidden)) signal.LeaveOut(k);
    }
  return settled_s;
}

}  // namespace fourpost
