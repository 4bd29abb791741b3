#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "analysis/text/units.h"
#include "identify/study_file/control.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Numbers of the positions of something that can be set, such as the rates of a damper by its clicks.
struct PositionTable {
  struct Column {
    std::string name;
    Dimension dimension;
    /// SI, one per row.
    std::vector<double> values;
  };

  std::string file;
  /// Positions as written, one per row.
  std::vector<std::string> rows;
  /// Their numbers, which rise; empty where they are names.
  std::vector<double> numbers;
  std::vector<Column> columns;

  std::optional<std::size_t> FindColumn(const std::string& name) const;
  /// Row of a position: a whole number for one that is written there, between two rows where positions are numbers;
  /// nothing outside the table or for an unknown name.
  std::optional<double> RowOf(const std::string& position) const;
  /// At a row of RowOf(), straight lines between rows.
  double At(std::size_t column, double row) const;
  /// "1 .. 20", or the names.
  std::string RangeText() const;
};

/// A text file whose first column has the positions and whose others have a unit each. Adds every fault; nothing when
/// there was one.
std::optional<PositionTable> ReadPositionTable(const std::filesystem::path& file, Diagnostics& diagnostics);

/// A fitted damper on its bench, or a vehicle, and the settings that the study of the run states under 'control'.
struct BenchRun {
  std::filesystem::path folder;
  Vehicle vehicle;
  Control control;
  /// They rise.
  std::vector<double> settings;

  /// All parameters at the settings, where the fit had found `values` (SI, order of Vehicle::parameters).
  PositionTable TableAt(std::span<const double> values) const;
};

/// Adds every fault; nothing when there was one.
std::optional<BenchRun> ReadBenchRun(const std::filesystem::path& run, Diagnostics& diagnostics);

/// The same as fitted.
std::optional<PositionTable> PositionTableOfRun(const std::filesystem::path& run, Diagnostics& diagnostics);

}  // namespace fourpost
