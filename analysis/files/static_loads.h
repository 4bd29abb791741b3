#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "analysis/text/units.h"

namespace fourpost {

/// One quantity measured at rest: a corner load, a length, a mass.
struct StaticMeasurement {
  std::string name;
  /// In the SI unit of the dimension.
  double value = 0;
  /// Standard deviation, in the same unit; 0 for what is taken as exact.
  double sd = 0;
  Dimension dimension;
};

/// Reads a table, of text or in a MAT file, with the columns quantity, unit, value, sd; every row has its own unit, as
/// ParseUnit takes it.
/// Reports all of: what ReadRecordedTable reports, missing or unknown columns, a quantity without or with another one's
/// name, an unknown unit, a value or sd that is missing or not a number, a negative sd. Nothing when there was one.
std::optional<std::vector<StaticMeasurement>> ReadStaticLoads(const std::filesystem::path& file,
                                                              Diagnostics& diagnostics);

}  // namespace fourpost
