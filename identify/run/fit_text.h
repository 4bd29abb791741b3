#pragma once

#include <string>

#include "identify/fit/fit.h"
#include "identify/run/fit_verdict.h"

namespace fourpost {

/// What `fourpost fit` tells on a terminal: tables of the parameters and of their profiles, `sections` (tables of what
/// was measured), how the fit ended, how large the misfit is, and what the data say worst.
std::string FitText(const FitResult& fit, const FitVerdict& verdict, bool has_deviations, const std::string& sections);

}  // namespace fourpost
