#include "analysis/restored_signal.h"

#include <algorithm>
#include <cstddef>

#include "analysis/option_check.h"

namespace fourpost {
namespace {

constexpr int kTerms = 4;

/// Undoes the poles of a section; its two zeros, of gain 1 at rest, remain.
void UndoPoles(const LowPass::Section& section, std::vector<double>& signal) {
  const double scale = 1 / (4 * section.b0);
  double before = signal.front();
  double earlier = before;
  for (double& sample : signal) {
    const double now = sample;
    sample = scale * (now + section.a1 * before + section.a2 * earlier);
    earlier = before;
    before = now;
  }
}

/// What `signal` is `samples` later; the last sample stays.
void Advance(std::size_t samples, std::vector<double>& signal) {
  for (std::size_t k = 0; k < signal.size(); ++k) signal[k] = signal[std::min(k + samples, signal.size() - 1)];
}

/// s applied to a signal that rests beyond its ends.
std::vector<double> HalfAngle(const std::vector<double>& signal) {
  std::vector<double> result(signal.size());
  const std::size_t last = signal.size() - 1;
  for (std::size_t k = 0; k <= last; ++k)
    result[k] = 0.25 * (2 * signal[k] - signal[k == 0 ? 0 : k - 1] - signal[std::min(k + 1, last)]);
  return result;
}

void UndoZeros(std::size_t half_order, std::vector<double>& signal) {
  Advance(half_order, signal);
  std::vector<double> term = signal;
  double factor = 1;
  for (int j = 1; j < kTerms; ++j) {
    term = HalfAngle(term);
    factor *= (static_cast<double>(half_order) + j - 1) / j;
    for (std::size_t k = 0; k < signal.size(); ++k) signal[k] += factor * term[k];
  }
}

}  // namespace

std::vector<double> RestoredSignal(const LowPass& filter, std::span<const double> filtered) {
  std::vector<double> signal(filtered.begin(), filtered.end());
  if (signal.empty()) return signal;
  for (const LowPass::Section& section : filter.sections()) {
    RequireOption(section.b2 != 0, "order of the filter to undo", 2 * filter.sections().size() - 1, "even");
    UndoPoles(section, signal);
  }
  UndoZeros(filter.sections().size(), signal);
  return signal;
}

}  // namespace fourpost
