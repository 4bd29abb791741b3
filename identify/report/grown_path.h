#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace fourpost {

/// Html of how a fit grew (`growth` of result.json); empty of any other.

/// Of one that was interrupted, as a part of the verdict; empty of one that ended.
std::string InterruptedGrowth(const nlohmann::json& result);
/// Its steps, and why it ended.
std::string HowItGrew(const nlohmann::json& result);

}  // namespace fourpost
