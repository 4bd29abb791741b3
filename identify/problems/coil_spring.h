#pragma once

#include <array>

#include "identify/search/evaluation.h"

namespace fourpost {

/// Diameters of wire that can be bought [in].
inline constexpr std::array<double, 42> kSpringWires_in = {
    0.009, 0.0095, 0.0104, 0.0118, 0.0128, 0.0132, 0.014, 0.015, 0.0162, 0.0173, 0.018, 0.020, 0.023,  0.025,
    0.028, 0.032,  0.035,  0.041,  0.047,  0.054,  0.063, 0.072, 0.080,  0.092,  0.105, 0.120, 0.135,  0.148,
    0.162, 0.177,  0.192,  0.207,  0.225,  0.244,  0.263, 0.283, 0.307,  0.331,  0.362, 0.394, 0.4375, 0.500};

/// Least volume of wire of a compression spring under eight constraints (Sandgren, J. Mechanical Design 112, 1990;
/// thesis ch. 2): number of coils 1..70, place of the wire in the catalogue, coil diameter 0.6..3 in; inches and
/// pounds. The cost is the volume [in^3], the one residual its root. Best is 2.658559 at 9 coils of the wire 0.283 on a
/// diameter of 1.223041; the next best wire costs 1.5 % more. `diameter_step`: precision of the diameter [in]; from
/// 1e-4 on the best volume is out of reach.
Problem CoilSpringProblem(double diameter_step);

/// Prints 2.6586, the digits that are published.
inline constexpr double kCoilSpringTarget = 2.65865;

}  // namespace fourpost
