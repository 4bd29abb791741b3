#pragma once

#include <string_view>
#include <vector>

#include "analysis/files/mat/mat_variable.h"

namespace fourpost {

/// The matrices of a MAT file of version 4 ("MAT-File Format", MathWorks, chapter 2): numbers and texts. Throws
/// MatFault for what is none.
std::vector<MatVariable> ReadMatVersion4(std::string_view bytes);

}  // namespace fourpost
