#include "analysis/signals/release_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fourpost {
namespace {

/// Samples from the first on to before the last.
using Part = std::pair<std::size_t, std::size_t>;

/// Of finite samples.
struct Moments {
  std::size_t count = 0;
  double mean = 0;
  double deviation = 0;
};

Moments MomentsOf(std::span<const double> signal, const Part& part) {
  Moments moments;
  for (std::size_t k = part.first; k < part.second; ++k)
    if (std::isfinite(signal[k])) ++moments.count, moments.mean += signal[k];
  if (moments.count == 0) return moments;
  moments.mean /= static_cast<double>(moments.count);
  for (std::size_t k = part.first; k < part.second; ++k)
    if (std::isfinite(signal[k])) moments.deviation += std::pow(signal[k] - moments.mean, 2);
  moments.deviation = std::sqrt(moments.deviation / static_cast<double>(moments.count));
  return moments;
}

double Farthest(std::span<const double> signal, const Part& part, double from) {
  double farthest = 0;
  for (std::size_t k = part.first; k < part.second; ++k)
    if (std::isfinite(signal[k])) farthest = std::max(farthest, std::abs(signal[k] - from));
  return farthest;
}

/// The releases of one record.
class ReleaseSearch {
 public:
  ReleaseSearch(std::span<const std::span<const double>> signals, double rate_Hz) : signals_(signals) {
    constexpr std::size_t kFewestSamples = 16;
    constexpr double kBlock_s = 0.05;
    constexpr double kMost = 1e6;
    samples_ = signals.empty() ? 0 : signals.front().size();
    block_ = std::max(kFewestSamples, static_cast<std::size_t>(std::clamp(kBlock_s * rate_Hz, 0.0, kMost)));
    moves_.assign(samples_ / block_, false);
    shortest_ = static_cast<std::size_t>(std::clamp(0.5 * rate_Hz, 0.0, kMost)) / block_;
    for (const std::span<const double> signal : signals) AddMotion(signal);
    CloseShortRests();
  }

  std::vector<ReleaseSamples> Found() const {
    std::vector<ReleaseSamples> found;
    std::size_t rest_from = 0;
    for (std::size_t from = 0; from < moves_.size();) {
      if (!moves_[from]) {
        ++from;
        continue;
      }
      const std::size_t begin = EndOf(from);
      const std::size_t end = EndOf(begin);
      const std::size_t to = SettledFrom(begin, end);
      // The last block of a record may be cut.
      const std::size_t last = end == moves_.size() ? samples_ : end * block_;
      ReleaseSamples one = {rest_from * block_, 0, to * block_, last};
      one.let_go = FirstAwayFrom(one.rest_from, from);
      if (from == 0) one.rest_from = 0;
      if (to < moves_.size() && end - to >= std::max<std::size_t>(1, shortest_) && IsRelease(one)) found.push_back(one);
      rest_from = begin;
      from = end;
    }
    return found;
  }

 private:
  /// Marks the blocks in which a signal moves.
  void AddMotion(std::span<const double> signal) {
    constexpr double kBeyond = 3;
    constexpr double kOfAll = 2e-3;
    std::vector<double> deviations;
    for (std::size_t b = 0; b < moves_.size(); ++b)
      // With half of the next, so that none begins where a step is.
      deviations.push_back(MomentsOf(signal, {b * block_, std::min(samples_, (2 * b + 3) * block_ / 2)}).deviation);
    if (deviations.empty()) return quiet_.push_back(0);
    std::vector<double> sorted = deviations;
    std::sort(sorted.begin(), sorted.end());
    const double quiet = sorted[sorted.size() / 10];
    quiet_.push_back(quiet);
    const double most = std::max(kBeyond * quiet, kOfAll * MomentsOf(signal, {0, samples_}).deviation);
    // One that is all noise moves nowhere.
    for (std::size_t b = 0; b < moves_.size(); ++b) moves_[b] = moves_[b] || deviations[b] > most;
  }

  /// A vehicle that swings rests for a moment at its turning points.
  void CloseShortRests() {
    for (std::size_t b = 0; b < moves_.size();) {
      const std::size_t end = EndOf(b);
      if (!moves_[b] && b > 0 && end < moves_.size() && 2 * (end - b) < shortest_)
        std::fill(moves_.begin() + static_cast<std::ptrdiff_t>(b), moves_.begin() + static_cast<std::ptrdiff_t>(end),
                  true);
      b = end;
    }
  }

  /// Behind the last block that is as this one.
  std::size_t EndOf(std::size_t block) const {
    std::size_t end = block;
    while (end < moves_.size() && moves_[end] == moves_[block]) ++end;
    return end;
  }

  /// Of a rest, the block from where on no level is away from that of the half second behind it: what swings out
  /// slowly hides in the noise of a block.
  std::size_t SettledFrom(std::size_t begin, std::size_t end) const {
    std::size_t settled = begin;
    for (std::size_t b = begin; b + 1 + shortest_ < end && b < settled + std::max<std::size_t>(1, shortest_); ++b)
      for (std::size_t i = 0; i < signals_.size(); ++i) {
        const double level = MomentsOf(signals_[i], {b * block_, (b + 1) * block_}).mean;
        const double behind = MomentsOf(signals_[i], {(b + 1) * block_, (b + 1 + shortest_) * block_}).mean;
        if (shortest_ > 0 && std::abs(level - behind) > quiet_[i]) settled = b + 1;
      }
    return settled;
  }

  /// The first sample of any signal that leaves its rest for good, in the block before the one that moves, in this or
  /// in the next.
  std::size_t FirstAwayFrom(std::size_t rest_from, std::size_t block) const {
    constexpr double kAway = 6;
    constexpr double kOfAll = 1e-3;
    if (block < 2 || rest_from >= (block - 1) * block_) return block * block_;
    const Part rest = {std::max(rest_from, (block - 1) * block_ - std::min((block - 1) * block_, 20 * block_)),
                       (block - 1) * block_};
    const Part search = {rest.second, std::min(samples_, (block + 2) * block_)};
    std::size_t first = search.second;
    for (const std::span<const double> signal : signals_) {
      const Moments still = MomentsOf(signal, rest);
      const double away = std::max(kAway * still.deviation, kOfAll * MomentsOf(signal, {0, samples_}).deviation);
      const auto is_away = [&](std::size_t k) { return std::abs(signal[k] - still.mean) > away; };
      for (std::size_t k = search.first; k < first && k + 1 < search.second; ++k)
        if (is_away(k) && is_away(k + 1)) first = k;
    }
    return first == search.second ? block * block_ : first;
  }

  bool IsRelease(const ReleaseSamples& one) const {
    constexpr double kSudden = 0.1;
    constexpr double kLoud = 0.2;
    constexpr double kFades = 0.5;
    bool is_sudden = one.let_go == one.rest_from;
    bool is_loud = false;
    int moving = 0;
    int fading = 0;
    const std::size_t third = (one.rest - one.let_go) / 3;
    for (const std::span<const double> signal : signals_) {
      const Moments after = MomentsOf(signal, {one.rest, one.end});
      const Moments before = MomentsOf(signal, {one.rest_from, std::max(one.let_go, one.rest_from + 1)});
      const double most = Farthest(signal, {one.let_go, one.rest}, after.mean);
      if (most < 10 * after.deviation || most == 0) continue;
      const double all = Farthest(signal, {0, samples_}, after.mean);
      is_loud = is_loud || most > kLoud * all;
      const std::size_t soon = std::min(one.rest, one.let_go + block_ + 1);
      is_sudden = is_sudden || Farthest(signal, {one.let_go, soon}, before.mean) > kSudden * most;
      ++moving;
      const double late = Farthest(signal, {one.rest - third, one.rest}, after.mean);
      if (late < kFades * most) ++fading;
    }
    return is_sudden && is_loud && 2 * fading > moving;
  }

  std::span<const std::span<const double>> signals_;
  std::size_t samples_ = 0;
  /// Samples of a block, and blocks of the shortest rest that counts.
  std::size_t block_ = 1;
  std::size_t shortest_ = 0;
  std::vector<bool> moves_;
  /// Of each signal, the deviation in its quietest blocks.
  std::vector<double> quiet_;
};

}  // namespace

std::vector<ReleaseSamples> ReleasesOf(std::span<const std::span<const double>> signals, double rate_Hz) {
  return ReleaseSearch(signals, rate_Hz).Found();
}

double DriftAtRest(std::span<const double> signal, std::span<const ReleaseSamples> releases) {
  double product = 0;
  double square = 0;
  std::size_t count = 0;
  for (const ReleaseSamples& release : releases)
    for (const Part& part : {Part{release.rest_from, release.let_go}, Part{release.rest, release.end}}) {
      const double mean = MomentsOf(signal, part).mean;
      const double middle = 0.5 * (static_cast<double>(part.first) + static_cast<double>(part.second) - 1);
      for (std::size_t k = part.first; k < part.second; ++k) {
        if (!std::isfinite(signal[k])) continue;
        const double time = static_cast<double>(k) - middle;
        product += time * (signal[k] - mean);
        square += time * time;
        ++count;
      }
    }
  return count < 3 || square == 0 ? 0 : product / square * static_cast<double>(signal.size() - 1);
}

double StepOf(std::span<const double> signal, const ReleaseSamples& release, double noise) {
  const Moments before = MomentsOf(signal, {release.rest_from, release.let_go});
  const Moments after = MomentsOf(signal, {release.rest, release.end});
  const double step = before.mean - after.mean;
  return before.count == 0 || std::abs(step) <= noise * after.deviation ? 0 : step;
}

}  // namespace fourpost
