#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace fourpost {

/// What was done to recordings before they were used, from the entries of result.json that have a `preparation`;
/// `name`: the key of their names. Empty where nothing was done.
std::string PreparationsHtml(const std::vector<nlohmann::json>& recordings, const char* name);

}  // namespace fourpost
