#pragma once

#include <filesystem>
#include <vector>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Standard deviation of an amplitude that the recordings of a fit show, by sensor, SI: the root mean square over the
/// frequencies of the channel with its name in response.csv. NaN for a sensor without one, or without repeats.
std::vector<double> RecordedNoise(const std::filesystem::path& run, const Vehicle& vehicle);

}  // namespace fourpost
