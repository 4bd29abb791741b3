#pragma once

#include <limits>
#include <numbers>

#include "vehicles/condensed/modes.h"

namespace fourpost {

// Times of a mode after the thesis, from angular frequency w and pole -sigma +- i w_d (eqs. 4.13-4.14); for an
// overdamped mode from the slow sigma; NaN for a free or diverging mode.

/// 1.8 / w: rise time of the step response.
inline double RiseTime_s(const Mode& mode) {
  if (!(mode.frequency_Hz > 0)) return std::numeric_limits<double>::quiet_NaN();
  return 1.8 / (2 * std::numbers::pi * mode.frequency_Hz);
}

/// 4.6 / sigma: time after which the step response stays within a hundredth.
inline double SettlingTime_s(const Mode& mode) {
  if (!(mode.frequency_Hz > 0)) return std::numeric_limits<double>::quiet_NaN();
  return 4.6 / -mode.pole.real();
}

}  // namespace fourpost
