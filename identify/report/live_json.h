#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "identify/experiments/run_contents.h"
#include "identify/report/run_result.h"

namespace fourpost {

/// What a page needs to follow other values of the parameters: the reduced vehicle, base 64 of BytesOf(), and its
/// parameters, those that were fitted first. analysis/report/README.md describes the shape. Null where the folder has
/// no vehicle, or one that cannot be condensed.
nlohmann::ordered_json LiveJson(const RunContents& run, const std::vector<ReportedParameter>& fitted);

}  // namespace fourpost
