#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "analysis/files/mat/mat_variable.h"

namespace fourpost {

/// Whether the bytes begin an HDF5 file, as those of version 7.3 are.
bool IsMatVersion73(std::string_view bytes);

/// The variables of a MAT file of version 7.3 (HDF5), as ReadMatVersion5 has them. What is asked for of each is
/// compared with the bytes that the file stores of it before any memory is taken, and what HDF5 cannot stand is a fault
/// of the file. Throws MatFault.
std::vector<MatVariable> ReadMatVersion73(const std::filesystem::path& file);

}  // namespace fourpost
