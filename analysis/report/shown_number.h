#pragma once

#include <string>

#include "analysis/report/html.h"

namespace fourpost {

/// At so many significant digits, without an exponent from 1e-4 to 1e7, thousands apart by a thin space, and with a
/// minus sign: "12 534", "-0.031", "2.5·10⁻⁹"; "–" for NaN.
std::string ShownNumber(double value, int digits);

/// Likewise, without zeros at the end: as a user would write a round number.
std::string ShownShort(double value, int digits);

/// At so many decimals.
std::string ShownDecimals(double value, int decimals);

/// Decimals at which a value is shown that is known to this standard deviation: two digits of that; four digits of the
/// value where the deviation is not finite.
int DecimalsFor(double value, double sd);

/// A standard deviation beside its value; a dash where there is none.
html::Cell SdCell(double sd, int decimals);

/// A unit with dots and raised powers: "kg\u00b7m\u00b2" for "kg*m^2".
std::string ShownUnit(const std::string& unit);

}  // namespace fourpost
