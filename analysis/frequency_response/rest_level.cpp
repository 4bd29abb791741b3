#include "analysis/frequency_response/rest_level.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "analysis/frequency_response/settled_part.h"
#include "analysis/frequency_response/sine_fit.h"
#include "analysis/signals/deviation.h"
#include "analysis/signals/median.h"

namespace fourpost {
namespace {

RestLevel LevelOf(std::span<const double> still, double rate_Hz) {
  constexpr double kBlock_s = 0.1;
  const auto size = static_cast<std::size_t>(std::max(1.0, std::round(kBlock_s * rate_Hz)));
  std::vector<double> means;
  for (std::size_t first = 0; first + size <= still.size(); first += size)
    means.push_back(Mean(still.subspan(first, size)));
  return {.mean = Mean(still), .variance = VarianceOfMean(std::span<const double>(means))};
}

struct Motion {
  double size = 0;
  double cycles_per_sample = 0;
  /// What noise lets it be at most.
  double noise = 0;
};

/// Looks at blocks of half a second, one behind the other.
class RestSearch {
 public:
  RestSearch(const RigSignals& signals, std::span<const Dwell> dwells) : signals_(signals) {
    constexpr double kRest = 5e-3;
    constexpr double kLeast_s = 0.5;
    constexpr double kNoise = 0.1;
    length_ = std::max<std::size_t>(16, static_cast<std::size_t>(std::ceil(kLeast_s * signals.rate_Hz)));
    std::vector<double> amplitudes;
    for (const Dwell& dwell : dwells) {
      amplitudes.push_back(dwell.amplitude);
      tones_.push_back(dwell.cycles_per_sample);
    }
    limit_ = kRest * *std::max_element(amplitudes.begin(), amplitudes.end());
    most_noise_ = std::max(limit_, kNoise * Median(amplitudes));
    KeepDistinctTones();
  }

  std::size_t length() const { return length_; }
  double limit() const { return limit_; }

  bool IsStill(std::size_t first) const { return !Largest(first); }

  /// Of any post in the block; nothing where all are still.
  std::optional<Motion> Largest(std::size_t first) const {
    std::optional<Motion> largest;
    for (const std::span<const double> post : signals_.posts) {
      const std::span<const double> block = post.subspan(first, length_);
      Motion motion = MotionOf(block);
      const double deviation = DeviationOf(block);
      // Of whatever frequency.
      if (deviation > std::max(most_noise_, motion.size)) motion = {deviation, 0, 0};
      const bool is_moved = motion.size > limit_ + motion.noise || deviation > most_noise_;
      if (is_moved && (!largest || motion.size > largest->size)) largest = motion;
    }
    return largest;
  }

 private:
  /// A block must hold nearly a cycle, and dwells repeat.
  void KeepDistinctTones() {
    constexpr double kSame = 1.01;
    constexpr double kFewest = 0.9;
    std::sort(tones_.begin(), tones_.end());
    std::vector<double> kept;
    for (const double tone : tones_)
      if (tone * static_cast<double>(length_) >= kFewest && (kept.empty() || tone > kSame * kept.back()))
        kept.push_back(tone);
    tones_ = std::move(kept);
  }

  Motion MotionOf(std::span<const double> block) const {
    constexpr double kDeviations = 4;
    const double of_one = kDeviations * DeviationOf(block) / std::sqrt(static_cast<double>(block.size()));
    const std::array<std::span<const double>, 1> signals = {block};
    Motion largest{.size = 0, .cycles_per_sample = 0, .noise = std::sqrt(2.0) * of_one};
    for (const double tone : tones_) {
      const double size = std::abs(FitSines(signals, 0, block.size(), tone, 1, 0).front().phasor.front());
      if (size > largest.size) largest = {size, tone, largest.noise};
    }
    if (largest.size > limit_ + largest.noise) return largest;
    const std::size_t third = block.size() / 3;
    const double drift = 1.5 * std::abs(Mean(block.last(third)) - Mean(block.first(third)));
    return {drift, 0, std::sqrt(12.0) * of_one};
  }

  const RigSignals& signals_;
  std::size_t length_ = 0;
  std::vector<double> tones_;
  double limit_ = 0;
  double most_noise_ = 0;
};

}  // namespace

Rest RestBefore(const RigSignals& signals, std::span<const Dwell> dwells) {
  Rest rest;
  if (dwells.empty()) return rest;
  const RestSearch search(signals, dwells);
  rest.limit = search.limit();
  std::size_t still = 0;
  while (still + search.length() <= signals.samples() && search.IsStill(still)) still += search.length();
  for (std::size_t c = 0; still > 0 && c < signals.channels.size(); ++c)
    rest.levels.push_back(LevelOf(signals.channels[c].first(still), signals.rate_Hz));
  if (still > 0 || signals.samples() < search.length()) return rest;
  const std::optional<Motion> motion = search.Largest(0);
  rest.motion = motion->size;
  rest.frequency_Hz = motion->cycles_per_sample * signals.rate_Hz;
  return rest;
}

}  // namespace fourpost
