#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Reads a vehicle description: URDF by urdfdom, `fp:` tags by our reader; urdf/README.md is the format's reference.
/// Adds every finding to `diagnostics` with file and line; returns nothing after an error. Meshes are read to check
/// them. A parameter without bounds is fixed: lower = value = upper and precision = 0.
std::optional<Vehicle> ReadVehicle(const std::filesystem::path& file, Diagnostics& diagnostics);

/// The same for a text, the content of `file`. Findings name `file`, and meshes are looked for beside it.
std::optional<Vehicle> ReadVehicleText(const std::string& text, const std::filesystem::path& file,
                                       Diagnostics& diagnostics);

/// Vehicle::text with other parameter values (SI, order of Vehicle::parameters), each in the unit it was written in,
/// with the numbers of the tree that follow them, with Vehicle::parameters' sources, and without the priors that
/// Vehicle::parameters does not have. All else is kept byte for byte. The file itself is not read again: it may have
/// changed or been deleted. The text is meant for a file in `folder`: mesh files are named relative to it, and curves
/// from files are written out where it is another folder than the vehicle's. Reading it gives the same doubles back.
/// Values outside a parameter's bounds give a file with errors. Throws std::invalid_argument for a wrong number of
/// values, and for a vehicle without a text.
std::string VehicleTextWithValues(const Vehicle& vehicle, std::span<const double> parameters,
                                  const std::filesystem::path& folder);

}  // namespace fourpost
