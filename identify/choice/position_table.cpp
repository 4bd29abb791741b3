#include "identify/choice/position_table.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/files/csv.h"
#include "analysis/text/number.h"
#include "analysis/text/unit_spelling.h"
#include "identify/choice/findings.h"
#include "identify/study/loaded_study.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

/// Numbers of the positions where all are numbers that rise.
std::vector<double> NumbersOf(const std::vector<std::string>& rows) {
  std::vector<double> numbers;
  for (const std::string& row : rows) {
    const std::optional<double> number = ParseNumber(row);
    if (!number || (!numbers.empty() && !(*number > numbers.back()))) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<PositionTable::Column> ColumnOf(const CsvTable& csv, std::size_t column, Diagnostics& diagnostics) {
  PositionTable::Column read{.name = csv.names()[column], .dimension = {}, .values = {}};
  const std::string unit_text = csv.units().empty() ? "" : csv.units()[column];
  const std::optional<Unit> unit = ParseUnit(unit_text.empty() ? "1" : unit_text);
  if (!unit) {
    diagnostics.Report(kPositionsUnit, {csv.file(), csv.units_line()}, {read.name, unit_text, UnitHint(unit_text)});
    return std::nullopt;
  }
  read.dimension = unit->dimension;
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    const double number = csv.Number(row, column).value_or(std::nan(""));
    if (std::isnan(number)) diagnostics.Report(kPositionsNumber, {csv.file(), csv.line(row)}, {read.name});
    read.values.push_back(number * unit->si);
  }
  return read;
}

void CheckRows(const CsvTable& csv, const PositionTable& table, Diagnostics& diagnostics) {
  if (csv.columns() < 2 || csv.rows() < 2) diagnostics.Report(kPositionsFew, {csv.file(), csv.names_line()});
  std::set<std::string> seen;
  for (std::size_t row = 0; row < csv.rows(); ++row)
    if (!seen.insert(table.rows[row]).second)
      diagnostics.Report(kPositionsTwice, {csv.file(), csv.line(row)}, {table.rows[row]});
}

}  // namespace

std::optional<std::size_t> PositionTable::FindColumn(const std::string& name) const {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].name == name) return i;
  return std::nullopt;
}

std::optional<double> PositionTable::RowOf(const std::string& position) const {
  const auto row = std::find(rows.begin(), rows.end(), position);
  if (row != rows.end()) return static_cast<double>(row - rows.begin());
  const std::optional<double> number = numbers.empty() ? std::nullopt : ParseNumber(position);
  if (!number || *number < numbers.front() || *number > numbers.back()) return std::nullopt;
  const auto above = std::max(std::lower_bound(numbers.begin(), numbers.end(), *number), numbers.begin() + 1);
  const auto below = above - 1;
  return static_cast<double>(below - numbers.begin()) + (*number - *below) / (*above - *below);
}

double PositionTable::At(std::size_t column, double row) const {
  const std::vector<double>& values = columns[column].values;
  const auto below = std::min(static_cast<std::size_t>(row), values.size() - 1);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], row - static_cast<double>(below));
}

std::string PositionTable::RangeText() const {
  if (!numbers.empty()) return rows.front() + " .. " + rows.back();
  std::string text;
  for (const std::string& row : rows) text += (text.empty() ? "" : ", ") + row;
  return text;
}

std::optional<PositionTable> ReadPositionTable(const std::filesystem::path& file, Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.items().size();
  const std::optional<CsvTable> csv = ReadCsv(file, diagnostics, CsvHeader::kNamesAndUnits);
  if (!csv) return std::nullopt;
  PositionTable table;
  table.file = file.string();
  for (std::size_t row = 0; row < csv->rows(); ++row) table.rows.push_back(csv->Text(row, 0));
  table.numbers = NumbersOf(table.rows);
  CheckRows(*csv, table, diagnostics);
  for (std::size_t column = 1; column < csv->columns(); ++column)
    if (std::optional<PositionTable::Column> read = ColumnOf(*csv, column, diagnostics))
      table.columns.push_back(std::move(*read));
  if (diagnostics.items().size() > before) return std::nullopt;
  return table;
}

std::optional<BenchRun> ReadBenchRun(const std::filesystem::path& run, Diagnostics& diagnostics) {
  std::optional<Vehicle> vehicle = ReadVehicle(run / "vehicle.urdf", diagnostics);
  const std::optional<Study> study = ReadStudy(run / "study.yaml", diagnostics);
  if (!vehicle || !study) return std::nullopt;
  std::set<double> settings;
  for (const Experiment& experiment : study->experiments)
    for (const double setting : experiment.Settings()) settings.insert(setting);
  Control control = ControlOf(*study, *vehicle);
  if (control.empty() || settings.size() < 2) {
    diagnostics.Report(kPositionsNoControl, {(run / "study.yaml").string()});
    return std::nullopt;
  }
  return BenchRun{run, *std::move(vehicle), std::move(control), {settings.begin(), settings.end()}};
}

PositionTable BenchRun::TableAt(std::span<const double> values) const {
  PositionTable table;
  table.file = folder.string();
  table.numbers = settings;
  for (const Parameter& parameter : vehicle.parameters)
    table.columns.push_back({.name = parameter.name, .dimension = parameter.dimension, .values = {}});
  for (const double setting : settings) {
    table.rows.push_back(FormatNumber(setting));
    const std::vector<double> there = control.At(setting).At({values.begin(), values.end()});
    for (std::size_t i = 0; i < there.size(); ++i) table.columns[i].values.push_back(there[i]);
  }
  return table;
}

std::optional<PositionTable> PositionTableOfRun(const std::filesystem::path& run, Diagnostics& diagnostics) {
  const std::optional<BenchRun> bench = ReadBenchRun(run, diagnostics);
  if (!bench) return std::nullopt;
  return bench->TableAt(bench->vehicle.ParameterValues());
}

}  // namespace fourpost
