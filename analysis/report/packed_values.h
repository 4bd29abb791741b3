#pragma once

#include <vector>

#include <nlohmann/json.hpp>

namespace fourpost {

/// Numbers for the scripts, packed: {"rows", "first", "step"} where each is a step further than the one before, within
/// a thousandth of it; else {"rows", "scale", "packed"}, whole numbers of a scale, the largest of which is 32767,
/// -32768 where there is none: of each its difference to the one before, 16 bits, all low bytes before all high ones,
/// by zlib in base 64.
nlohmann::ordered_json PackedValues(const std::vector<double>& values);

}  // namespace fourpost
