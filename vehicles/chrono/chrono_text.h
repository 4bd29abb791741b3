#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// A vehicle file of a vehicle of Project Chrono, see ReadChronoVehicle(). Chrono's points are not those at rest: the
/// car is let down onto its springs first, with Chrono's preloads and free lengths, and is written as it then stands,
/// with the points of wheels, arms and axles moved in the frame of the chassis. Where it finds no rest it is written as
/// drawn, with a warning. `name`: of the vehicle; `place`: of its file, for findings. Empty after an error.
std::string ChronoVehicleText(const std::filesystem::path& file, const std::vector<std::filesystem::path>& tyres,
                              const std::string& name, const std::string& place, Diagnostics& diagnostics);

}  // namespace fourpost
