#pragma once

#include <optional>
#include <span>
#include <string>

#include "analysis/diagnostics.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Adds an error for each post that would leave its stroke, half of it up and half of it down from rest.
/// `excursion_m`: the largest distance from rest, one per post; `motion`: what moves them so, as messages call it:
/// "heave at 0.5 Hz"; `otherwise_m`: stroke of a post whose file tells none, if it has an end.
void CheckStroke(const Vehicle& vehicle, std::span<const double> excursion_m, const std::string& motion,
                 Diagnostics& diagnostics, std::optional<double> otherwise_m = {});

}  // namespace fourpost
