#pragma once

#include <vector>

#include "analysis/low_pass.h"

namespace fourpost {

/// A signal through a low-pass forwards and then backwards: no phase, the gain squared, not causal. Both ways begin
/// settled (LowPass::ApplySettled) on the signal turned about its ends, 3 (2 sections + 1) samples long, three less for
/// an odd order, as scipy.signal.sosfiltfilt does it. Throws std::invalid_argument for a signal that is not longer.
std::vector<double> ZeroPhase(std::vector<double> signal, const LowPass& filter);

}  // namespace fourpost
