#pragma once

#include <optional>
#include <string>

namespace fourpost {

/// What a recording through a low-pass filter is told where it has fewer than four samples a period of the cut-off: "is
/// sampled at 50 Hz, too slowly ...". A filter of fourth order leaves a tenth at 1.8 times its cut-off, so that with
/// four next to nothing is folded back from beyond half the sampling rate, and the filter is undone up to a fourth
/// above its cut-off.
std::optional<std::string> RateFault(double rate_Hz, double cutoff_Hz);

}  // namespace fourpost
