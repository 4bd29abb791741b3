#include "identify/experiments/four_post/coarse_runs.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace fourpost {
namespace {

/// Every fourth frequency from the lowest on; all where these are few.
MeasuredRun CoarseRun(const MeasuredRun& run) {
  constexpr std::size_t kStep = 4;
  // The full Land Rover keeps 16 of 64 over six octaves, and from all three of its starts they lead to its best
  // optimum.
  constexpr std::size_t kLeast = 12;
  const std::vector<double>& frequencies = run.excitation.frequency_Hz;
  if (frequencies.size() < kStep * kLeast) return run;
  std::vector<std::size_t> order(frequencies.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return frequencies[a] < frequencies[b]; });
  std::vector<bool> keep(frequencies.size());
  for (std::size_t i = 0; i < order.size(); i += kStep) keep[order[i]] = true;
  return AtFrequencies(run, keep);
}

}  // namespace

std::optional<std::vector<MeasuredRun>> CoarseRuns(const std::vector<MeasuredRun>& runs) {
  std::vector<MeasuredRun> coarse;
  std::size_t left_out = 0;
  for (const MeasuredRun& run : runs) {
    coarse.push_back(CoarseRun(run));
    left_out += run.excitation.frequency_Hz.size() - coarse.back().excitation.frequency_Hz.size();
  }
  return left_out > 0 ? std::optional(std::move(coarse)) : std::nullopt;
}

}  // namespace fourpost
