#pragma once

#include <cstddef>
#include <span>

namespace fourpost {

/// Smallest difference between two values of a signal, which is the resolution of its converter or of its file;
/// 0 of a constant. What differs by less than 1e-9 of the span is rounding of the same level.
double LevelOf(std::span<const double> signal);

/// Samples in runs at the greatest value that begin or end steeply, as a converter at the end of its range leaves them:
/// a rounded crest leaves its greatest level by one level. Runs shorter than four do not count.
std::size_t ClippedAtTop(std::span<const double> signal, double level);
std::size_t ClippedAtBottom(std::span<const double> signal, double level);

/// So many clipped samples are clipped: a crest with noise of a few levels may have one run of four.
inline constexpr std::size_t kFewestClipped = 12;

}  // namespace fourpost
