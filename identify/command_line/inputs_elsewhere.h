#pragma once

#include <filesystem>
#include <vector>

#include "identify/loaded_study.h"

namespace fourpost {

/// The files that a study is read from.
std::vector<std::filesystem::path> InputsOf(const LoadedStudy& study);

/// Throws OutputError when the folder, which results shall be written to, holds one of the files that are read.
void RequireInputsElsewhere(const std::vector<std::filesystem::path>& inputs, const std::filesystem::path& folder);

}  // namespace fourpost
