#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fourpost {

/// Reads a finite decimal number that fills the whole text ("0.3", "-1.5e-3", "+2"), times ten to `power_of_ten`,
/// rounded once: ParseNumber("1.1", -3) is the double 0.0011. Independent of the locale. Nothing for any other text.
std::optional<double> ParseNumber(std::string_view text, int power_of_ten = 0);

/// `value` times ten to `power_of_ten` at the fewest digits that ParseNumber(text, -power_of_ten) reads back to the
/// same double: "31.42", "1.5e-7".
std::string FormatNumber(double value, int power_of_ten = 0);

}  // namespace fourpost
