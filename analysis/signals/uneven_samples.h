#pragma once

#include <span>
#include <vector>

namespace fourpost {

/// Values between samples at times that rise but need not be even: a cubic between two samples, with the slopes that
/// the parabolas through three samples have at them (an error of third order of the spacing). Between equal samples,
/// four or more in a row, it stands, as a clipped signal does. Beyond the ends the last cubic goes on. Throws
/// std::invalid_argument for fewer than three samples, and for times that do not rise.
std::vector<double> InterpolatedAt(std::span<const double> times, std::span<const double> values,
                                   std::span<const double> at);

}  // namespace fourpost
