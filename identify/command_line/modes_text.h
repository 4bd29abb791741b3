#pragma once

#include <string>
#include <vector>

#include "vehicles/requests/pole_files.h"

namespace fourpost {

/// What `fourpost modes` shows on a terminal: a table of poles, one of shapes, and of each parameter that is varied
/// what becomes of the poles from its first value to its last.
std::string ModesText(const Vehicle& vehicle, const std::vector<ShapedMode>& modes,
                      const std::vector<PolePaths>& paths);

}  // namespace fourpost
