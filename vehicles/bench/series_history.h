#pragma once

#include <vector>

#include "vehicles/bench/bench_motion.h"
#include "vehicles/laws/series_damper.h"

namespace fourpost {

/// Most steps err by far less; what is left of the force is some 1e-5 of its rms where laws have kinks.
inline constexpr double kSeriesTolerance = 1e-5;

/// Force of a series damper at the samples of a motion [N], from a spring at rest at the first sample.
/// A linear spring and a dashpot of straight pieces (bilinear, digressive) are solved exactly, see StraightSeries; any
/// other pair by error-controlled implicit steps, see ImplicitSeries, to some 1e-5 of the force's rms. Both hold for
/// whatever stiffness. Samples of the motion are joined by the spline that MotionThrough has made of them.
/// `tolerance`: of a step of the latter, as a share of the force that is likely.
std::vector<double> SeriesForces(const SeriesDamper& damper, const BenchMotion& motion,
                                 double tolerance = kSeriesTolerance);

}  // namespace fourpost
