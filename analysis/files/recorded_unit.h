#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "analysis/text/units.h"

namespace fourpost {

/// A unit as measurement systems write it: all that ParseUnit takes, and "m/s²", "m/s2", "mm/sec", "°/s", "µm", "-",
/// "inches", "Newton", "ips", "mph", "klbf". In a recording "g" is the standard gravity; nobody records grams. Bytes of
/// Latin-1 count as those of UTF-8.
std::optional<Unit> ParseRecordedUnit(std::string_view text);

/// As UnitHint() of one that ParseRecordedUnit does not know, in brackets or not; else empty.
std::string RecordedUnitHint(std::string_view text);

/// "0.02 g": as ParseQuantity, with a unit of a recording.
std::optional<Quantity> ParseRecordedQuantity(std::string_view text);

/// "mm" of "[mm]" and "(mm)"; else the text as it is.
std::string WithoutBrackets(std::string_view unit);

/// A column's name and its unit, which may be empty.
struct NamedColumn {
  std::string name;
  std::string unit;
};

/// Takes "Force [kN]" apart, and "Force (kN)" and "Force / kN" where what stands behind the name is a unit.
NamedColumn SplitColumnName(std::string_view text);

}  // namespace fourpost
