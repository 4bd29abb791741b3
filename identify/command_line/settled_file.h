#pragma once

#include <filesystem>
#include <string>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/poses/settled_pose.h"

namespace fourpost {

/// Whether springs keep the preload or free length that they state, or leave both to equilibrium.
enum class StatedForces { kKept, kLeftToEquilibrium };

/// The text of the vehicle's file with its pose at rest as design pose, for a file in `folder`: joints have other
/// origins; preloads, gaps of stops and the gas of dampers are those at rest; free lengths stay. All else is kept byte
/// for byte. Adds an error for each element that no file can state at rest.
std::string SettledText(const Vehicle& vehicle, const SettledPose& pose, StatedForces stated,
                        const std::filesystem::path& folder, Diagnostics& findings);

/// The text with the preloads, or with the free lengths, that hold the design pose, of springs that state one. Adds an
/// error where nothing holds it.
enum class Holding { kPreload, kFreeLength };
std::string HeldText(const Vehicle& vehicle, const SettledPose& pose, Holding holding,
                     const std::filesystem::path& folder, Diagnostics& findings);

}  // namespace fourpost
