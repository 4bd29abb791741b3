#pragma once

#include <optional>
#include <span>
#include <string>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Adds an error for each post that would leave its stroke, half of it up and half of it down from rest. `excursion_m`:
/// the largest distance from rest, one per post; `motion`: name of the motion in messages: "heave at 0.5 Hz";
/// `otherwise_m`: stroke of a post without one in its file, if limited.
void CheckStroke(const Vehicle& vehicle, std::span<const double> excursion_m, const std::string& motion,
                 Diagnostics& diagnostics, std::optional<double> otherwise_m = {});

}  // namespace fourpost
