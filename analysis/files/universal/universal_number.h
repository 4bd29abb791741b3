#pragma once

#include <optional>
#include <string_view>

namespace fourpost {

/// Takes the number that `text` begins with, as FORTRAN writes it: "-3.81956E+00", "0.00000E+000", "1.5D-3",
/// "0.12345-105", with no blank before the next one's sign. Nothing at the end and before other text.
std::optional<double> TakeUniversalNumber(std::string_view& text);

/// "  12" without its blanks; nothing for other text. An empty field is 0.
std::optional<double> UniversalField(std::string_view field);

}  // namespace fourpost
