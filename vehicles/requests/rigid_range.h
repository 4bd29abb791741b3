#pragma once

#include <string>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// Above this frequency the bodies of a road vehicle bend; the model's bodies are rigid.
inline constexpr double kHighestRigid_Hz = 30;

/// Adds a warning about the option that exceeds it.
void WarnAboveRigid(double highest_Hz, const std::string& option, Diagnostics& diagnostics);

}  // namespace fourpost
