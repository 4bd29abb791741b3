#pragma once

#include <algorithm>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "vehicles/ride/vehicle_summary.h"

namespace fourpost {

/// Where a mode of this name must lie.
struct ModeBand {
  std::string mode;
  double lower_Hz = 0;
  double upper_Hz = 0;
};

inline void ExpectWithin(std::span<const ModeBand> bands, const VehicleSummary& summary) {
  for (const ModeBand& band : bands) {
    const auto mode = std::find_if(summary.modes.begin(), summary.modes.end(),
                                   [&](const Mode& candidate) { return candidate.name == band.mode; });
    ASSERT_NE(mode, summary.modes.end()) << band.mode;
    EXPECT_GT(mode->frequency_Hz, band.lower_Hz) << band.mode;
    EXPECT_LT(mode->frequency_Hz, band.upper_Hz) << band.mode;
  }
}

}  // namespace fourpost
