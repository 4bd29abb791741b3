#include "analysis/signals/held_samples.h"

#include <algorithm>
#include <cmath>

namespace fourpost {
namespace {

constexpr std::size_t kShortest = 5;
constexpr std::size_t kShortestInNoise = 10;
constexpr double kMoves = 0.1;
constexpr double kJumps = 2;
/// Of steps that are not zero: of a signal alone, and of all at once.
constexpr double kFine = 0.9;
constexpr double kFineTogether = 0.5;

double Step(const std::vector<double>& signal, std::size_t to) { return signal[to] - signal[to - 1]; }

/// That have one sample before and one behind, with `stands(k)`: sample k is that before.
template <typename Stands>
std::vector<HeldSamples> LongStands(std::size_t samples, const Stands& stands) {
  std::vector<HeldSamples> found;
  for (std::size_t k = 1; k < samples; ++k) {
    if (!stands(k)) continue;
    const std::size_t first = k;
    while (k + 1 < samples && stands(k + 1)) ++k;
    if (k - first + 1 >= kShortest && first > 1 && k + 2 < samples) found.push_back({first, k});
  }
  return found;
}

/// What a signal does about a stretch, without it and the step behind it.
struct Surroundings {
  /// Share of steps that are not zero, and of those the share whose sign differs from that of the one before.
  double moving = 0;
  double turning = 0;
  /// Of 95 of 100 steps that are not zero.
  double usual = 0;
};

Surroundings SurroundingsOf(const std::vector<double>& signal, const HeldSamples& stand) {
  constexpr std::size_t kFewest = 50;
  constexpr double kMost = 0.95;
  const std::size_t reach = std::max(kFewest, 2 * (stand.last - stand.first + 1));
  std::vector<double> sizes;
  double all = 0;
  double turns = 0;
  double before = 0;
  for (std::size_t k = stand.first > reach ? stand.first - reach : 1;
       k < std::min(signal.size(), stand.last + 2 + reach); ++k) {
    if (k >= stand.first && k <= stand.last + 1) continue;
    const double step = Step(signal, k);
    if (!std::isfinite(step)) continue;
    ++all;
    if (step == 0) continue;
    sizes.push_back(std::abs(step));
    turns += before * step < 0 ? 1 : 0;
    before = step;
  }
  if (sizes.empty()) return {};
  const auto count = static_cast<double>(sizes.size());
  const auto place = sizes.begin() + static_cast<std::ptrdiff_t>(kMost * (count - 1));
  std::nth_element(sizes.begin(), place, sizes.end());
  return {.moving = count / all, .turning = turns / count, .usual = *place};
}

/// Of the three steps before a stretch.
double LargestBefore(const std::vector<double>& signal, const HeldSamples& stand) {
  double largest = 0;
  for (std::size_t k = std::max<std::size_t>(stand.first, 4) - 3; k < stand.first; ++k)
    largest = std::max(largest, std::abs(Step(signal, k)));
  return largest;
}

bool IsExtreme(const std::vector<double>& signal, double value) {
  constexpr double kNear = 0.02;
  double least = value;
  double most = value;
  for (const double one : signal) {
    if (one < least) least = one;
    if (one > most) most = one;
  }
  return std::min(value - least, most - value) < kNear * (most - least);
}

bool IsHeld(const std::vector<double>& signal, const HeldSamples& stand, double fine) {
  constexpr double kNoise = 0.1;
  if (Step(signal, stand.last + 2) == 0) return false;
  const Surroundings about = SurroundingsOf(signal, stand);
  if (about.moving < fine || LargestBefore(signal, stand) <= kMoves * about.usual) return false;
  if (std::abs(Step(signal, stand.last + 1)) > kJumps * about.usual) return true;
  return stand.last - stand.first + 1 >= kShortestInNoise && about.turning > kNoise &&
         !IsExtreme(signal, signal[stand.first]);
}

/// Of one signal by itself.
std::vector<HeldSamples> HeldAlone(const std::vector<double>& signal) {
  std::vector<HeldSamples> held = LongStands(signal.size(), [&](std::size_t k) { return Step(signal, k) == 0; });
  // Of a signal that often stands none is remarkable.
  constexpr std::size_t kMost = 200;
  if (held.size() > kMost) return {};
  std::erase_if(held, [&](const HeldSamples& stand) { return !IsHeld(signal, stand, kFine); });
  // One that dropped to another value has not even its first sample.
  for (HeldSamples& stand : held)
    if (std::abs(Step(signal, stand.first - 1)) > kJumps * SurroundingsOf(signal, stand).usual) --stand.first;
  return held;
}

std::vector<HeldSamples> HeldTogether(const std::vector<const std::vector<double>*>& signals) {
  if (signals.size() < 2) return {};
  std::vector<HeldSamples> held = LongStands(signals.front()->size(), [&](std::size_t k) {
    return std::all_of(signals.begin(), signals.end(), [&](const auto* signal) { return Step(*signal, k) == 0; });
  });
  std::erase_if(held, [&](const HeldSamples& stand) {
    const auto count = std::count_if(signals.begin(), signals.end(),
                                     [&](const auto* signal) { return IsHeld(*signal, stand, kFineTogether); });
    return 3 * count < std::ssize(signals);
  });
  return held;
}

bool Changes(const std::vector<double>& signal) {
  return std::any_of(signal.begin(), signal.end(), [&](double value) { return value != signal.front(); });
}

/// Both in order, those that overlap as one.
std::vector<HeldSamples> Merged(std::vector<HeldSamples> all) {
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<HeldSamples> merged;
  for (const HeldSamples& one : all)
    if (!merged.empty() && one.first <= merged.back().last + 1)
      merged.back().last = std::max(merged.back().last, one.last);
    else merged.push_back(one);
  return merged;
}

/// More is how the signal was made.
bool IsRare(const std::vector<HeldSamples>& held, std::size_t samples) {
  std::size_t count = 0;
  for (const HeldSamples& one : held) count += one.last - one.first + 1;
  return 5 * count < samples;
}

}  // namespace

std::vector<std::vector<HeldSamples>> HeldStretches(std::span<const std::vector<double>> signals) {
  std::vector<std::vector<HeldSamples>> held(signals.size());
  const auto is_of_other_length = [&](const auto& signal) { return signal.size() != signals.front().size(); };
  if (signals.empty() || std::any_of(signals.begin(), signals.end(), is_of_other_length)) return held;
  std::vector<const std::vector<double>*> changing;
  for (const std::vector<double>& signal : signals)
    if (Changes(signal)) changing.push_back(&signal);
  const std::vector<HeldSamples> together = HeldTogether(changing);
  for (std::size_t i = 0; i < signals.size(); ++i) {
    std::vector<HeldSamples> of = HeldAlone(signals[i]);
    if (Changes(signals[i])) of.insert(of.end(), together.begin(), together.end());
    of = Merged(std::move(of));
    if (IsRare(of, signals[i].size())) held[i] = std::move(of);
  }
  return held;
}

}  // namespace fourpost
