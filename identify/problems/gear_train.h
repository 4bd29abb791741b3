#pragma once

#include "identify/search/evaluation.h"

namespace fourpost {

/// Teeth A, B, C, D of 12 to 60 each for a ratio A B / (C D) nearest to 1 / 6.931 (Sandgren, J. Mechanical Design 112,
/// 1990; thesis ch. 2). The one residual is the error of the ratio. Of all 49^4 designs four are best, 2.7008571e-12:
/// 16 and 19, 43 and 49 teeth in either order; the next costs 2.3e-11.
Problem GearTrainProblem();

/// Between the best cost and the next.
inline constexpr double kGearTrainTarget = 2.70086e-12;

}  // namespace fourpost
