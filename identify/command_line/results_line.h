#pragma once

#include <filesystem>

namespace fourpost {

/// The page of a folder of results, as `fourpost fit` names it.
inline constexpr const char* kPageName = "report.html";

/// Says on stderr where results are and which page to open.
void PrintResultsLine(const std::filesystem::path& folder);

}  // namespace fourpost
