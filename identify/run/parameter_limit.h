#pragma once

#include <string>

#include "identify/fit/fit_result.h"

namespace fourpost {

/// What most of a parameter's deviation comes from, see Certainty::LimitedBy(); "stated error" in place of "noise"
/// where residuals are less than half of what the study states, so that the statement is the limit and no longer test.
inline std::string LimitOf(const FitResult& fit, const FittedParameter& parameter) {
  constexpr double kFarBelow = 0.5;
  const bool is_stated = parameter.limited_by == "noise" && fit.Misfit() < kFarBelow;
  return is_stated ? "stated error" : parameter.limited_by;
}

}  // namespace fourpost
