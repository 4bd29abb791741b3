#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/fit/fit.h"
#include "identify/run/growth_path.h"

namespace fourpost {

/// Root mean square over the channels of validation recordings of what is left of them, in per cent; NaN without.
double ValidationPercent(const nlohmann::json& result);

/// Those of `names` that ended at a bound.
std::vector<std::string> AtBound(const FitResult& fit, const std::vector<std::string>& names);

/// Whether recordings that are held back can say that something is real of which the stated errors ask for nothing.
bool HasValidation(const GrowthStep& step);

/// Whether a step that was fitted is kept upon the one before, and why not: the criterion must fall and validation
/// recordings be predicted no worse; better, where the stated errors explain the residuals without it.
void Judge(const GrowthStep& before, GrowthStep& step);

}  // namespace fourpost
