#pragma once

#include <cstdint>
#include <string>

#include "identify/comparison.h"

namespace fourpost {

/// A comparison as JSON text. `expected_evaluations` and its upper bound are null without a success, costs are null
/// where no evaluation succeeded.
std::string ComparisonJson(const Comparison& comparison, const std::string& study, std::uint64_t seed);

}  // namespace fourpost
