#pragma once

#include <span>

#include "analysis/signals/uniform_spline.h"

namespace fourpost {

/// The spline through samples whose slopes at both ends are not known: those of the cubics through the first and the
/// last four, see SlopeAtStart(). Throws as UniformSpline does.
UniformSpline SplineThrough(std::span<const double> samples, double start, double step);

}  // namespace fourpost
