#include "analysis/signals/clipping.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "analysis/signals/median.h"
#include "analysis/signals/signal_levels.h"
#include "analysis/text/short_number.h"

namespace fourpost {
namespace {

/// Samples first to end - 1.
struct Run {
  std::size_t first = 0;
  std::size_t end = 0;

  std::size_t count() const { return end - first; }
};

std::vector<Run> RunsAbove(std::span<const double> signal, double least) {
  std::vector<Run> runs;
  for (std::size_t k = 0; k < signal.size(); ++k) {
    if (signal[k] < least) continue;
    if (runs.empty() || runs.back().end != k) runs.push_back({k, k});
    runs.back().end = k + 1;
  }
  return runs;
}

/// Standard deviation of what differs from sample to sample in the upper twentieth.
double NoiseAtTop(std::span<const double> signal, double top, double span) {
  constexpr double kUpper = 0.05;
  std::vector<double> steps;
  for (const Run& run : RunsAbove(signal, top - kUpper * span))
    for (std::size_t k = run.first + 1; k < run.end; ++k) steps.push_back(std::abs(signal[k] - signal[k - 1]));
  if (steps.empty()) return 0;
  return 1.4826 * Median(std::move(steps)) / std::numbers::sqrt2;
}

/// Whether the signal falls below `level` within an eighth of the run of it on both sides.
bool EndsSteeply(std::span<const double> signal, const Run& run, double level) {
  const std::size_t reach = std::max<std::size_t>(1, run.count() / 8);
  const bool rises = run.first >= reach && signal[run.first - reach] < level;
  const bool falls = run.end + reach <= signal.size() && signal[run.end + reach - 1] < level;
  return rises && falls;
}

std::optional<Clipping> ExactlyAtTop(std::span<const double> signal, double top) {
  const std::size_t samples = ClippedAtTop(signal, LevelOf(signal));
  if (samples < kFewestClipped) return std::nullopt;
  const auto first = static_cast<std::size_t>(std::find(signal.begin(), signal.end(), top) - signal.begin());
  return Clipping{.level = top, .noise = 0, .samples = samples, .first = first};
}

std::optional<Clipping> NearlyAtTop(std::span<const double> signal, double top, double span) {
  // Ten thousand samples of normal noise span 7.7 s on average.
  constexpr double kBand = 8;
  // Within an eighth of a run more a parabola, which any crest is, falls by 1.25^2 - 1 = 0.56 of its depth.
  constexpr double kSteep = 3;
  // The next sample of a parabola falls by 3 of the depth beside a run of two, by 0.8 beside one of six.
  constexpr std::size_t kFewestInRow = 6;
  // Of the span: under more, a force of friction looks like it.
  constexpr double kMostNoise = 1.5e-3;
  const double noise = NoiseAtTop(signal, top, span);
  if (noise == 0 || noise > kMostNoise * span) return std::nullopt;
  Clipping clipping{.noise = noise};
  for (const Run& run : RunsAbove(signal, top - kBand * noise)) {
    if (run.count() < kFewestInRow || !EndsSteeply(signal, run, top - (1 + kSteep) * kBand * noise)) continue;
    if (clipping.samples == 0) clipping.first = run.first;
    clipping.samples += run.count();
    for (std::size_t k = run.first; k < run.end; ++k) clipping.level += signal[k];
  }
  if (clipping.samples < kFewestClipped) return std::nullopt;
  clipping.level /= static_cast<double>(clipping.samples);
  return clipping;
}

}  // namespace

std::optional<Clipping> ClippingAtTop(std::span<const double> signal) {
  if (signal.empty()) return std::nullopt;
  const auto [least, most] = std::minmax_element(signal.begin(), signal.end());
  if (*least == *most) return std::nullopt;
  if (const std::optional<Clipping> exactly = ExactlyAtTop(signal, *most)) return exactly;
  return NearlyAtTop(signal, *most, *most - *least);
}

std::optional<Clipping> ClippingAtBottom(std::span<const double> signal) {
  std::vector<double> mirrored(signal.size());
  std::transform(signal.begin(), signal.end(), mirrored.begin(), [](double value) { return -value; });
  std::optional<Clipping> clipping = ClippingAtTop(mirrored);
  if (clipping) clipping->level = -clipping->level;
  return clipping;
}

bool ClippedEnds::is_exact() const { return (top && top->noise == 0) || (bottom && bottom->noise == 0); }

bool ClippedEnds::IsExactAt(double value) const {
  return (top && top->noise == 0 && value >= top->level) || (bottom && bottom->noise == 0 && value <= bottom->level);
}

std::size_t ClippedEnds::first() const {
  if (top && bottom) return std::min(top->first, bottom->first);
  return top ? top->first : bottom->first;
}

std::string ClippedEnds::Text(const std::string& unit, double first_s) const {
  return (is_exact() ? "is clipped: " : "looks clipped: ") + Samples(unit, first_s);
}

std::string ClippedEnds::Samples(const std::string& unit, double first_s) const {
  std::string text;
  for (const std::optional<Clipping>& end : {top, bottom})
    if (end)
      text += std::to_string(end->samples) + " samples stand at " + ShortNumber(end->level) + " " + unit +
              (end->noise == 0 ? " exactly, " : " but for noise of " + ShortNumber(end->noise, 2) + " " + unit + ", ");
  return text + "the first at " + ShortNumber(first_s, 5) + " s";
}

std::optional<ClippedEnds> ClippingAtEnds(std::span<const double> signal) {
  const ClippedEnds ends{.top = ClippingAtTop(signal), .bottom = ClippingAtBottom(signal)};
  if (!ends.top && !ends.bottom) return std::nullopt;
  return ends;
}

}  // namespace fourpost
