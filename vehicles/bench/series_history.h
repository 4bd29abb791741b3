#pragma once

#include <vector>

#include "vehicles/bench/bench_motion.h"
#include "vehicles/laws/series_damper.h"

namespace fourpost {

/// Force of a series damper at the samples of a motion [N], from a spring at rest at the first sample. The state y, the
/// spring's extension, goes by steps h of the implicit rule of two derivatives, of fourth order and stable for whatever
/// stiffness:
///   y1 = y0 + h/2 (y0' + y1') + h^2/12 (y0'' - y1''),  y' = v - u,  y'' = v' - spring'(y)/dashpot'(u) y'
/// with the dashpot's rate u for unknown, so that no law is inverted: spring(y1(u)) = dashpot(u), where y1(u) is linear
/// once the ratio of slopes is known. That ratio is taken at u of the step before for a first u, then at that one.
/// In steps of 1 ms the force of dampers with time constants of 0.5 ms and more errs by less than 1e-3 of its rms;
/// about a kink of the dashpot, where y'' jumps, the rule is of second order.
std::vector<double> SeriesForces(const SeriesDamper& damper, const BenchMotion& motion);

}  // namespace fourpost
