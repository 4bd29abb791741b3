#pragma once

#include <string>

#include "analysis/diagnostics.h"

namespace fourpost {

/// Above this frequency the bodies of a road vehicle bend, which a model of rigid bodies does not know.
inline constexpr double kHighestRigid_Hz = 30;

/// Adds a warning about the option that asks for more.
void WarnAboveRigid(double highest_Hz, const std::string& option, Diagnostics& diagnostics);

}  // namespace fourpost
