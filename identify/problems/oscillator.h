#pragma once

#include "identify/search/evaluation.h"

namespace fourpost {

/// Mass, spring and damper on a moving ground, m z'' + d (z' - u') + k (z - u) = 0 (thesis ch. 2): find m, k, d from
/// the motion z and the force m z''; from motions alone only k/m and d/m would be. u is a chirp of 20 mm from 0.5 to
/// 5 Hz in 5 s, linear between samples at 100 Hz, the motion exact for that; the thesis does not state its input.
/// Residuals: of each signal (y - y_true) / (sigma sqrt(N)) in per cent of variance, so that the cost is the sum of the
/// two MSE [%] (thesis eq. 3.9). No noise; 200 kg, 15000 N/m, 1500 N s/m cost nothing.
Problem OscillatorProblem();

/// MSE [%].
inline constexpr double kOscillatorTarget = 1e-6;

}  // namespace fourpost
