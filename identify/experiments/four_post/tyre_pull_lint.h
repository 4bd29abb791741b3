#pragma once

#include <span>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Tyres with liftoff="false" that pull on the ground when the vehicle, at these values of its parameters, answers the
/// recorded stepped sines: one warning each and recording.
void LintTyrePulls(const Vehicle& vehicle, std::span<const double> values, const std::vector<MeasuredRun>& runs,
                   Diagnostics& diagnostics);

}  // namespace fourpost
