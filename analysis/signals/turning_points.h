#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fourpost {

/// Samples at which a signal turns back, maxima and minima in turn: by more than a fifth of the swing before, so that
/// noise does not count while the amplitude falls; at first by more than 5 % of the signal's span.
std::vector<std::size_t> TurningPoints(std::span<const double> signal);

}  // namespace fourpost
