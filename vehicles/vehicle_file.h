#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "analysis/diagnostics.h"
#include "vehicles/vehicle.h"

namespace fourpost {

/// Reads a vehicle description: URDF by urdfdom, `fp:` tags by our reader.
/// Adds every fault to `diagnostics` with file and line; nothing when there was an error.
std::optional<Vehicle> ReadVehicle(const std::filesystem::path& file, Diagnostics& diagnostics);

/// The text of the vehicle's file with other parameter values (SI, order of Vehicle::parameters), comments and layout
/// kept, mesh file names replaced by `mesh_directory`/name. Throws std::runtime_error when the file cannot be read.
std::string VehicleTextWithValues(const Vehicle& vehicle, std::span<const double> parameters,
                                  const std::filesystem::path& mesh_directory);

}  // namespace fourpost
