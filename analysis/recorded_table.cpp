#include "analysis/recorded_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "analysis/number.h"

namespace fourpost {
namespace {

bool IsMatFile(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".mat";
}

}  // namespace

RecordedTable::RecordedTable(CsvTable csv) : file_(csv.file()), names_(csv.names()), units_(csv.units()) {
  units_.resize(names_.size());
  csv_ = std::move(csv);
}

RecordedTable::RecordedTable(std::string file, std::vector<MatVector> vectors)
    : file_(std::move(file)), vectors_(std::move(vectors)) {
  for (const MatVector& vector : vectors_) {
    names_.push_back(vector.name);
    units_.push_back(vector.unit);
  }
}

std::optional<std::size_t> RecordedTable::FindColumn(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names_.begin());
}

std::size_t RecordedTable::rows(std::size_t column) const {
  return csv_ ? csv_->rows() : vectors_[column].values.size();
}

std::optional<double> RecordedTable::Number(std::size_t row, std::size_t column) const {
  if (csv_) return csv_->Number(row, column);
  const double number = vectors_[column].values[row];
  return std::isinf(number) ? std::nullopt : std::optional(number);
}

std::string RecordedTable::Text(std::size_t row, std::size_t column) const {
  return csv_ ? csv_->Text(row, column) : FormatNumber(vectors_[column].values[row]);
}

std::string RecordedTable::WhereUnitsStand(const std::string& name, const std::string& such) const {
  if (csv_) return "in a line below the names, or behind the name, as in '" + name + " [" + such + "]'";
  return "as a text '" + name + "_unit' in the file";
}

std::optional<RecordedTable> ReadRecordedTable(const std::filesystem::path& file, Diagnostics& diagnostics) {
  if (!IsMatFile(file)) {
    std::optional<CsvTable> csv = ReadCsv(file, diagnostics, CsvHeader::kNamesAndUnits);
    if (!csv) return std::nullopt;
    return RecordedTable(*std::move(csv));
  }
  std::optional<std::vector<MatVector>> vectors = ReadMatFile(file, diagnostics);
  if (!vectors) return std::nullopt;
  return RecordedTable(file.string(), *std::move(vectors));
}

}  // namespace fourpost
