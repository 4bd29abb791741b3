#pragma once

#include <nlohmann/json.hpp>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// {"id": "mass-missing", "text": "car.urdf:12: ..."} of each warning, grave ones first, the file without its folder:
/// for results, which are read elsewhere.
nlohmann::ordered_json WarningsJson(const Diagnostics& diagnostics);

}  // namespace fourpost
