#include "analysis/files/static_loads.h"

#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "analysis/files/findings.h"
#include "analysis/files/recorded_table.h"
#include "analysis/text/number.h"
#include "analysis/text/unit_spelling.h"

namespace fourpost {
namespace {

constexpr std::array<std::string_view, 4> kColumns = {"quantity", "unit", "value", "sd"};

class StaticLoadsReader {
 public:
  StaticLoadsReader(const RecordedTable& table, Diagnostics& diagnostics) : table_(table), diagnostics_(diagnostics) {}

  std::optional<std::vector<StaticMeasurement>> Read() {
    std::vector<StaticMeasurement> measurements;
    for (row_ = 0; row_ < table_.rows(0); ++row_) measurements.push_back(ReadRow());
    if (!good_) return std::nullopt;
    return measurements;
  }

 private:
  void Fault(const Finding& kind, const std::vector<std::string>& words = {}) {
    table_.Report(kind, row_, words, diagnostics_);
    good_ = false;
  }

  std::string Text(std::string_view column) const { return table_.Text(row_, *table_.FindColumn(column)); }

  StaticMeasurement ReadRow() {
    StaticMeasurement measurement;
    measurement.name = Text("quantity");
    CheckName(measurement.name);
    const std::optional<Unit> unit = ParseUnit(Text("unit"));
    if (!unit) Fault(kQuantityUnit, {measurement.name, Text("unit"), UnitHint(Text("unit"))});
    else measurement.dimension = unit->dimension;
    measurement.value = ReadNumber("value", unit.has_value());
    measurement.sd = ReadNumber("sd", unit.has_value());
    if (measurement.sd < 0) Fault(kDeviationNegative, {measurement.name});
    return measurement;
  }

  void CheckName(const std::string& name) {
    if (name.empty()) return Fault(kQuantityNameless);
    const auto [first, is_new] = row_of_.emplace(name, row_);
    if (!is_new) Fault(kQuantityTwice, {name, table_.RowInWords(first->second)});
  }

  /// In SI if the unit is known.
  double ReadNumber(std::string_view column, bool has_unit) {
    const std::string text = Text(column);
    const std::optional<double> number = table_.Number(row_, *table_.FindColumn(column));
    if (!number || std::isnan(*number)) {
      if (text.empty()) Fault(kQuantityMissing, {Text("quantity"), std::string(column)});
      else Fault(kQuantityNotANumber, {Text("quantity"), std::string(column), text});
      return 0;
    }
    if (!has_unit) return *number;
    // The number together with its unit, for powers of ten without a rounding of their own.
    const std::optional<Quantity> quantity = ParseQuantity(FormatNumber(*number) + " " + Text("unit"));
    if (!quantity) Fault(kQuantityTooLarge, {Text("quantity"), std::string(column), text});
    return quantity ? quantity->si : 0;
  }

  const RecordedTable& table_;
  Diagnostics& diagnostics_;
  std::size_t row_ = 0;
  std::map<std::string, std::size_t> row_of_;
  bool good_ = true;
};

}  // namespace

std::optional<std::vector<StaticMeasurement>> ReadStaticLoads(const std::filesystem::path& file,
                                                              Diagnostics& diagnostics) {
  const std::optional<RecordedTable> table = ReadRecordedTable(file, diagnostics, CsvHeader::kNames);
  if (!table || !table->CheckColumns(kColumns, {}, diagnostics)) return std::nullopt;
  return StaticLoadsReader(*table, diagnostics).Read();
}

}  // namespace fourpost
