#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fourpost {

/// Samples `first` to `last` of a signal are those of the sample before.
struct HeldSamples {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Where a logger lost time, or one of its channels, and held the last value; per signal, in order. A stretch of five
/// samples or more that do not change, while the signal did until then, by a tenth of its usual steps at least, and does
/// after it, counts
/// - where the next step is more than twice as large as 95 of 100 steps about it, which are not zero: as of a plateau
///   that goes on where it would have been, not where it stopped;
/// - or, of ten samples or more, where steps about it change sign as noise makes them, and the value is none of the
///   signal's extremes, at which it is clipped.
/// Steps about it are those of twice its length before and behind, 50 at least, and nine of ten of them are not zero:
/// coarse converters and values that were repeated at a higher rate do not count. A signal that jumped to the value, as
/// a loose plug makes it, has no good sample there, not even the first. Where all signals that change at all
/// stand at once, half of the steps, and a third of the signals, are enough, and all are held. Signals of which a fifth
/// would be held, or that stand more than 200 times, are not judged, nor signals that differ in length.
std::vector<std::vector<HeldSamples>> HeldStretches(std::span<const std::vector<double>> signals);

}  // namespace fourpost
