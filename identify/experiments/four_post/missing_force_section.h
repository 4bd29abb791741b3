#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace fourpost {

/// `missing_force` of a result as HTML, with its picture where there is one (text of missing_force.svg, or null). Empty
/// of a result without it.
std::string MissingForceHtml(const nlohmann::json& result, const std::string* picture);

/// As a sentence for the summary; empty where nothing is named.
std::string MissingForceRemark(const nlohmann::json& result);

}  // namespace fourpost
