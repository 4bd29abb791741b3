#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/chrono/chrono_axle.h"
#include "vehicles/templates/axle_knowledge.h"
#include "vehicles/templates/axle_points.h"

namespace fourpost {

/// A vehicle of Project Chrono with two axles, in the frame of its chassis: hard points, masses, and laws of springs,
/// shocks, stops and bars. Tie rods, links and Panhard rods count by halves with what is at their ends.
struct ChronoVehicle {
  CarPoints points;
  KnownCar car;
};

/// Reads the vehicle's JSON file and those that it names; `tyres`: files of tyres, one of both axles, or front and
/// rear. The ground is where tyres of these radii and rates stand with their loads. `motion` of the front and the rear
/// axle. Adds every fault of all files to `diagnostics`; nothing where there is an error.
std::optional<ChronoVehicle> ReadChronoVehicle(const std::filesystem::path& file,
                                               const std::vector<std::filesystem::path>& tyres,
                                               const std::array<ChronoMotion, 2>& motion, Diagnostics& diagnostics);

}  // namespace fourpost
