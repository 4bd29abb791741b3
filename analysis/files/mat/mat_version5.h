#pragma once

#include <string_view>
#include <vector>

#include "analysis/files/mat/mat_variable.h"

namespace fourpost {

/// Whether the bytes begin a file of versions 5 to 7.
bool IsMatVersion5(std::string_view bytes);

/// The variables of a MAT file of versions 5 to 7 ("MAT-File Format", MathWorks, chapter 1): real numbers, texts, cells
/// and structures; others have no content. Throws MatFault; what it holds is bounded by the bytes that are there, and
/// of compressed variables by 1 GiB.
std::vector<MatVariable> ReadMatVersion5(std::string_view bytes);

}  // namespace fourpost
