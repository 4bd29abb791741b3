#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fourpost {

/// Samples `first` to `last` of all signals are those of the sample before.
struct HeldSamples {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Where a logger lost time and held its last values: five samples or more at which no signal changes, not even by its
/// noise, while more than half of them change before by more than a tenth of their rms step thereabouts, and jump
/// afterwards by more than twice that. So neither a vehicle at rest counts nor a ramp that pauses. In order; none of one
/// signal. `signals`: equally long.
std::vector<HeldSamples> HeldStretches(std::span<const std::vector<double>> signals);

}  // namespace fourpost
