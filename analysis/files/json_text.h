#pragma once

#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

namespace fourpost {

// All JSON that fourpost writes passes here. Names of files and channels may be any bytes: what is no UTF-8 in them is
// written as U+FFFD, where nlohmann's dump() alone would throw and lose the results.

/// What is not finite has no number in JSON.
inline nlohmann::ordered_json NumberOrNull(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

/// On one line, without a line end.
template <typename Json>
std::string CompactJson(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// As a file of its own.
template <typename Json>
std::string JsonText(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace fourpost
