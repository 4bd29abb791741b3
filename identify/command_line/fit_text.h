#pragma once

#include <string>

#include "identify/fit.h"
#include "identify/fit_verdict.h"
#include "identify/loaded_study.h"

namespace fourpost {

/// What `fourpost fit` tells on a terminal: tables of the parameters and of their profiles, `sections` (tables of what
/// was measured), how the fit ended, how large the misfit is, and what the data say worst.
std::string FitText(const LoadedStudy& loaded, const FitResult& fit, const FitVerdict& verdict,
                    const std::string& sections);

}  // namespace fourpost
