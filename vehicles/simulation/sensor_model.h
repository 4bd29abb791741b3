#pragma once

#include <cstdint>
#include <optional>

#include "vehicles/simulation/time_history.h"

namespace fourpost {

/// Model of a rig's data acquisition, the same for every engine: its low-pass filter, at the rate of the samples, on
/// posts and sensors, and noise. Readings of load cells already include the mass of wheelpans.
struct SensorModel {
  struct Filter {
    int order = 4;
    double cutoff_Hz = 0;
  };
  std::optional<Filter> filter;
  /// Standard deviation of white noise as a share of each channel's own standard deviation, added after the filter.
  double noise = 0;
  std::uint64_t seed = 0;

  /// Changes posts and readings. Channels are numbered, posts first: the noise of one does not depend on the others.
  /// Throws std::invalid_argument for a filter that LowPass refuses, and for noise that is negative or not finite.
  void Apply(TimeHistory& history) const;
};

}  // namespace fourpost
