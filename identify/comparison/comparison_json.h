#pragma once

#include <cstdint>
#include <string>

#include "identify/comparison/comparison.h"

namespace fourpost {

/// A comparison as JSON text. `expected_evaluations` and its upper bound are null without a success, costs are null
/// where no evaluation succeeded. `outcomes` has evaluations and cost of every run. `time`: with the seconds of a run,
/// which no two comparisons have alike.
std::string ComparisonJson(const Comparison& comparison, const std::string& study, std::uint64_t seed,
                           bool time = false);

}  // namespace fourpost
