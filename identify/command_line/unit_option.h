#pragma once

#include <vector>

#include <CLI/App.hpp>

#include "analysis/measured_response/stated_unit.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

/// Adds `--unit CHANNEL=mm`, once for each; what is malformed is added to `faults`. Returns the option.
CLI::Option* AddUnitOption(CLI::App& app, std::vector<StatedUnit>& units, Diagnostics& faults);

}  // namespace fourpost
