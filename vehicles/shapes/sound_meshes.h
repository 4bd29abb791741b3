#pragma once

#include <filesystem>

namespace fourpost {

/// Reads a mesh for the sake of its faults, and throws as ReadMesh() does. A file that this process has read without
/// one is not read again until its size or its time changes: growth and suggestions read one vehicle hundreds of times.
void CheckMesh(const std::filesystem::path& file);

}  // namespace fourpost
