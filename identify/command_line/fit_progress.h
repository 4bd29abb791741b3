#pragma once

#include "identify/fit/fit.h"

namespace fourpost {

/// Shows how a fit with these options gets on; an interrupt by the user ends it with what it has.
FitHooks ShownFit(const FitOptions& options);

}  // namespace fourpost
