#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "identify/residuals/history_misfit.h"

namespace fourpost {

/// As in result.json; what is not finite is null, what was not computed is not there.
nlohmann::ordered_json HistoryMisfitsJson(const std::vector<HistoryMisfit>& misfits);

}  // namespace fourpost
