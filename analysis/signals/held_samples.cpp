#include "analysis/signals/held_samples.h"

#include <algorithm>
#include <cmath>

namespace fourpost {
namespace {

constexpr std::size_t kShortest = 5;
constexpr double kMoves = 0.1;
constexpr double kJumps = 2;

double Step(const std::vector<double>& signal, std::size_t to) { return signal[to] - signal[to - 1]; }

/// False where a sample is missing.
bool DoAllStand(std::span<const std::vector<double>> signals, std::size_t sample) {
  return std::all_of(signals.begin(), signals.end(),
                     [&](const std::vector<double>& signal) { return Step(signal, sample) == 0; });
}

/// Five samples or more that have one before and one behind.
std::vector<HeldSamples> LongStands(std::span<const std::vector<double>> signals) {
  std::vector<HeldSamples> stands;
  const std::size_t samples = signals.front().size();
  for (std::size_t k = 1; k < samples; ++k) {
    if (!DoAllStand(signals, k)) continue;
    const std::size_t first = k;
    while (k + 1 < samples && DoAllStand(signals, k + 1)) ++k;
    if (k - first + 1 >= kShortest && first > 1 && k + 1 < samples) stands.push_back({first, k});
  }
  return stands;
}

/// Rms of the steps before and behind a stretch, over twice its length, and 25 samples at least.
double StepAbout(const std::vector<double>& signal, const HeldSamples& stand) {
  constexpr std::size_t kFewest = 25;
  const std::size_t reach = std::max(kFewest, 2 * (stand.last - stand.first + 1));
  double squares = 0;
  double count = 0;
  for (std::size_t k = stand.first > reach ? stand.first - reach : 1;
       k < std::min(signal.size(), stand.last + 2 + reach); ++k) {
    // That across it is the jump.
    if (k >= stand.first && k <= stand.last + 1) continue;
    if (const double step = Step(signal, k); std::isfinite(step)) {
      squares += step * step;
      ++count;
    }
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

/// More than half of the signals change before, and jump behind.
bool IsHeld(std::span<const std::vector<double>> signals, const HeldSamples& stand) {
  std::size_t moving = 0;
  std::size_t jumping = 0;
  for (const std::vector<double>& signal : signals) {
    const double usual = StepAbout(signal, stand);
    moving += usual > 0 && std::abs(Step(signal, stand.first - 1)) > kMoves * usual ? 1 : 0;
    jumping += usual > 0 && std::abs(Step(signal, stand.last + 1)) > kJumps * usual ? 1 : 0;
  }
  return 2 * moving > signals.size() && 2 * jumping > signals.size();
}

}  // namespace

std::vector<HeldSamples> HeldStretches(std::span<const std::vector<double>> signals) {
  if (signals.size() < 2) return {};
  const auto is_of_other_length = [&](const auto& signal) { return signal.size() != signals.front().size(); };
  if (std::any_of(signals.begin(), signals.end(), is_of_other_length)) return {};
  std::vector<HeldSamples> held = LongStands(signals);
  std::erase_if(held, [&](const HeldSamples& stand) { return !IsHeld(signals, stand); });
  return held;
}

}  // namespace fourpost
