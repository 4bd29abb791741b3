#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace fourpost {

/// The engine that modelled each of these recordings of a result.json, and its error, HTML; empty of older runs.
std::string ModelledHtml(const std::vector<nlohmann::json>& recordings);

}  // namespace fourpost
