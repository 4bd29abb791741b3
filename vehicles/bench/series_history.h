#pragma once

#include <vector>

#include "vehicles/bench/bench_motion.h"
#include "vehicles/laws/series_damper.h"

namespace fourpost {

/// Most steps err by far less; the remaining error of the force is about 1e-5 of its rms where laws have kinks.
inline constexpr double kSeriesTolerance = 1e-5;

/// Force of a series damper at the samples of a motion [N], from an unloaded spring at the first sample. A linear
/// spring with a piecewise linear dashpot (bilinear, digressive) is solved exactly, see StraightSeries; any other pair
/// by error-controlled implicit steps, see ImplicitSeries, to about 1e-5 of the force's rms. Both hold for any
/// stiffness. Samples of the motion are joined by the spline of MotionThrough. `tolerance`: of an implicit step, as a
/// share of the expected force.
std::vector<double> SeriesForces(const SeriesDamper& damper, const BenchMotion& motion,
                                 double tolerance = kSeriesTolerance);

}  // namespace fourpost
