#pragma once

#include "identify/search/evaluation.h"

namespace fourpost {

/// Least cost of a cylindrical pressure vessel with two round heads under three constraints (Sandgren, J. Mechanical
/// Design 112, 1990; Kannan and Kramer, J. Mechanical Design 116, 1994): thickness of shell and heads in sixteenths of
/// an inch, 1..99, radius and length 10..200 in. The cost is that of material, forming and welding, the one residual
/// its root. Best is 6059.714335 with shells of 13, heads of 7 sixteenths, a radius of 42.098446 and a length of
/// 176.636596 (Gandomi, Yang and Alavi, Eng. with Computers 29, 2013); the next best pair of thicknesses costs 0.5 %
/// more.
Problem PressureVesselProblem();

/// Prints 6059.7, the digits that are published.
inline constexpr double kPressureVesselTarget = 6059.75;

}  // namespace fourpost
