#pragma once

#include <string>

#include "identify/fit/fit.h"
#include "identify/run/fit_verdict.h"

namespace fourpost {

/// What `fourpost fit` prints on a terminal: tables of the parameters and of their profiles, `sections` (tables of what
/// was measured), how the fit ended, how large the residuals are, the least identifiable direction, and the
/// conclusions.
std::string FitText(const FitResult& fit, const FitVerdict& verdict, const Diagnostics& conclusions,
                    const std::string& sections);

}  // namespace fourpost
