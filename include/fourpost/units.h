#pragma once

#include <string>

namespace fourpost::api {

/// The SI value of a number with a unit, such as "40 kN/m", of the same dimension as `unit` ("N/m"; "1" for none).
/// Throws Error (code `quantity-unreadable`) for a text without a known unit, or of another dimension.
double ToSi(const std::string& quantity, const std::string& unit);

/// The value with that unit, at the fewest digits that read back to the same double: InUnit(40e3, "kN/m") is "40 kN/m".
/// Throws Error (code `unit-unknown`) for an unknown unit.
std::string InUnit(double si, const std::string& unit);

/// The SI unit of the same dimension: "N/m" for "kN/m", "1" for "". Throws Error (code `unit-unknown`).
std::string SiUnitOf(const std::string& unit);

}  // namespace fourpost::api
