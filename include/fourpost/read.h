#pragma once

#include <filesystem>
#include <vector>

#include <fourpost/diagnostics.h>
#include <fourpost/vehicle.h>

namespace fourpost::api {

/// Reads a vehicle file, URDF with the tags of urdf/README.md. Adds warnings to `warnings` where given. Throws Error
/// with all faults of the file.
Vehicle ReadVehicle(const std::filesystem::path& file, std::vector<Finding>* warnings = nullptr);

/// What is plausible of a vehicle, as `fourpost check` warns: odd numbers, places, motion ratios, loads.
std::vector<Finding> CheckVehicle(const Vehicle& vehicle);

}  // namespace fourpost::api
