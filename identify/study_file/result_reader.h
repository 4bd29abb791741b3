#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace fourpost {

/// Bytes of a result.json; that of a fit of a hundred parameters is a tenth of it.
constexpr std::size_t kLargestResult = std::size_t{16} << 20;

/// The text of a result.json; a discarded value where it is no JSON, or none that fourpost writes: larger, or with
/// lists in lists that take the stack of whoever walks them.
nlohmann::json ParseResult(const std::string& text);

/// The same of a file; a discarded value where it cannot be read.
nlohmann::json ReadResultFile(const std::filesystem::path& file);

/// A number of an object of JSON; NaN where it is null, missing or no number.
double NumberAt(const nlohmann::json& object, const std::string& key);
/// Likewise a text; empty where there is none.
std::string TextAt(const nlohmann::json& object, const std::string& key);
/// Likewise a list.
std::vector<nlohmann::json> ListAt(const nlohmann::json& object, const std::string& key);

}  // namespace fourpost
