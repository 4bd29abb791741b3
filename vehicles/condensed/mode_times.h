#pragma once

#include <limits>
#include <numbers>

#include "vehicles/condensed/modes.h"

namespace fourpost {

// How long a mode takes, as the thesis estimates it from angular frequency w and pole -sigma +- i w_d (eqs. 4.13-4.14),
// of an overdamped one from the slow sigma; NaN of what is free or falls over.

/// 1.8 / w: until the response to a step has risen.
inline double RiseTime_s(const Mode& mode) {
  if (!(mode.frequency_Hz > 0)) return std::numeric_limits<double>::quiet_NaN();
  return 1.8 / (2 * std::numbers::pi * mode.frequency_Hz);
}

/// 4.6 / sigma: until it stays within a hundredth.
inline double SettlingTime_s(const Mode& mode) {
  if (!(mode.frequency_Hz > 0)) return std::numeric_limits<double>::quiet_NaN();
  return 4.6 / -mode.pole.real();
}

}  // namespace fourpost
