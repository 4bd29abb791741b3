#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/files/mat/mat_variable.h"

namespace fourpost {

/// Variables as bytes for another process of this program, and back. Throws MatFault for bytes that are none.
std::string Packed(const std::vector<MatVariable>& variables);
std::vector<MatVariable> Unpacked(std::string_view bytes);

/// The same of a fault.
std::string Packed(const MatFault& fault);
MatFault UnpackedFault(std::string_view bytes);

}  // namespace fourpost
