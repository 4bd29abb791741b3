#pragma once

#include <map>
#include <optional>
#include <string>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// What a run's folder holds, as far as a report shows it.
struct RunContents {
  /// Texts by file name; result.json among them.
  std::map<std::string, std::string> files;
  /// Of vehicle.urdf, the fitted vehicle; nothing where it cannot be read, and the reason.
  std::optional<Vehicle> vehicle;
  std::string vehicle_fault;
};

}  // namespace fourpost
