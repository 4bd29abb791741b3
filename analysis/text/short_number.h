#pragma once

#include <string>

namespace fourpost {

/// `value` at so many significant digits, 1 to 17; zero, infinities and NaN as they are.
double AtDigits(double value, int digits);

/// Likewise as text, without zeros at the end: "0.0123", "4e-6", "1230"; "unknown" for NaN and infinities. Independent
/// of the locale.
std::string ShortNumber(double value, int digits = 3);

}  // namespace fourpost
