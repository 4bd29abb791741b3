#pragma once

#include "analysis/text/diagnostics.h"
#include "identify/experiments/static_loads/static_loads.h"

namespace fourpost {

/// Before a fit: static loads that no masses within their bounds make.
void LintWeights(const StaticLoadTest& static_loads, const Subject& subject, Diagnostics& diagnostics);

/// Static loads after a fit, as warnings: all of them alike heavier or lighter than the forces in motion alone would
/// have them, as with wheelpans weighed along, with the range that the model's own error leaves; else those that are
/// off by more than noise, the other loads' misfit and the friction that holds a car at rest allow; else those that are
/// off by more than three of their standard deviations.
void LintLoads(const StaticLoadTest& measured, const Subject& subject, const FitResult& fit, Diagnostics& diagnostics);

}  // namespace fourpost
