#pragma once

#include <initializer_list>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// Moves errors of these kinds to `diagnostics`, and returns the rest: of a recording for validation, which is left out
/// for its own faults, those that are the study's, such as a name that the vehicle does not have.
Diagnostics WithoutOwnFaults(const Diagnostics& found, std::initializer_list<const Finding*> kinds,
                             Diagnostics& diagnostics);

}  // namespace fourpost
