#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fourpost {

/// Samples after which a smooth signal goes on elsewhere, as where samples are missing and times were closed up: the
/// step to the next one is off the median of the four steps about it by more than eight times the ninth of ten of all
/// steps, by five times what the two before it or the two behind it differ by, and by twelve times what most steps are
/// (1.4826 times the median of these distances). Those of Spikes are none. In order; none of fewer than six samples.
std::vector<std::size_t> Jumps(std::span<const double> signal);

}  // namespace fourpost
