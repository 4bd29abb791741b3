#pragma once

#include <cstddef>
#include <optional>
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

/// Of the additions that were refused upon the last step that was kept, the place of the best that may stand where no
/// other does; nothing where there is none. One whose parameter ends at a bound is not what the data show, but better
/// than nothing. One with which validation recordings are predicted worse may be a step on the way to more, as long as
/// the stated errors do not explain the residuals: what is far off says little about what is right.
std::optional<std::size_t> BestThatStoodBack(const GrowthPath& path);

/// Of the steps that were kept, the place of the last but where it predicts validation recordings worse than an earlier
/// one: then of that.
std::size_t BestPredicted(const GrowthPath& path);

}  // namespace fourpost
