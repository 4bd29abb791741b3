#pragma once

#include <filesystem>
#include <vector>

namespace fourpost {

/// Throws OutputError when the folder, which results shall be written to, holds one of the files that are read.
void RequireInputsElsewhere(const std::vector<std::filesystem::path>& inputs, const std::filesystem::path& folder);

}  // namespace fourpost
