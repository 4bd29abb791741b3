#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// Limits of a vehicle file for the XML parsers, which recurse into nested tags and compare the attributes of a tag
/// with each other. Far above the needs of a vehicle.
inline constexpr std::size_t kMostXmlBytes = 16 << 20;
inline constexpr std::size_t kMostXmlDepth = 64;
inline constexpr std::size_t kMostXmlElements = 200000;
inline constexpr std::size_t kMostXmlAttributes = 64;

/// Reports a file that is larger than kMostXmlBytes, before it is read. A file of unknown size passes.
bool HasLegalSize(const std::filesystem::path& file, FileFaults& faults);

/// Scans a text before it is parsed. Reports the first violation of the limits, document types (their entities may grow
/// without bound), NUL bytes, and markup that one XML parser takes for a tag and another does not. Other errors are
/// left to the parser.
bool IsWithinXmlLimits(std::string_view text, FileFaults& faults);

}  // namespace fourpost
