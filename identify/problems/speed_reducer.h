#pragma once

#include "identify/search/evaluation.h"

namespace fourpost {

/// Least weight of a speed reducer under eleven constraints (Golinski, J. Mechanisms 5, 1970): face width, module,
/// teeth of the pinion 17..28, two shaft lengths and two shaft diameters; centimetres. The one residual is the root of
/// the weight. Best is 2994.471066 at 3.5, 0.7, 17, 7.3, 7.715320, 3.350215, 5.286654 (Gandomi, Yang and Alavi, Eng.
/// with Computers 29, 2013, within 0.1 %).
Problem SpeedReducerProblem();

/// Prints 2994.5.
inline constexpr double kSpeedReducerTarget = 2994.55;

}  // namespace fourpost
