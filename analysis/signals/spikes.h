#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fourpost {

/// Samples that stand out: off the median of the five about them by more than a tenth of the signal's span and twelve
/// times what most samples are (1.4826 times the median of these distances, a standard deviation of normal noise). One
/// or two samples in a row, as of a bit lost or a loose plug; steps, crests and noise are none. In order; none of fewer
/// than five samples.
std::vector<std::size_t> Spikes(std::span<const double> signal);

}  // namespace fourpost
