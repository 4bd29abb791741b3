#pragma once

#include <vector>

#include "vehicles/bench/bench_motion.h"
#include "vehicles/laws/series_damper.h"

namespace fourpost {

/// Force of a series damper at the samples of a motion [N], from a spring at rest at the first sample.
/// A linear spring and a dashpot of straight pieces (bilinear, digressive) are solved exactly, see StraightSeries; any
/// other pair by error-controlled implicit steps, see ImplicitSeries, to some 1e-5 of the force's rms. Both hold for
/// whatever stiffness. Samples of the motion are joined by the spline that MotionThrough has made of them.
std::vector<double> SeriesForces(const SeriesDamper& damper, const BenchMotion& motion);

}  // namespace fourpost
