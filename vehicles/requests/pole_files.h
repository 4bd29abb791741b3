#pragma once

#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/condensed/state_space.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/ride/pole_path.h"
#include "vehicles/ride/shaped_modes.h"

namespace fourpost {

/// The state space, modes with poles and shapes, paths of poles, the values of all parameters, `findings` and versions
/// as JSON, in SI units; complex numbers are pairs.
std::string ModesJson(const Vehicle& vehicle, const StateSpace& space, const std::vector<ShapedMode>& modes,
                      const std::vector<PolePaths>& paths, const Diagnostics& findings);

/// Comma-separated text, one row per parameter, path and value; the parameter in SI units.
std::string PolesCsv(const Vehicle& vehicle, const std::vector<PolePaths>& paths);

/// The paths of one parameter as an SVG picture, see PoleSvg.
std::string PolesSvg(const Vehicle& vehicle, const PolePaths& paths);

}  // namespace fourpost
