#include "analysis/files/recorded_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "analysis/files/findings.h"
#include "analysis/text/nearest.h"
#include "analysis/text/number.h"

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
  NumberColumns();
}

RecordedTable::RecordedTable(std::string file, std::vector<MatVector> vectors)
    : file_(std::move(file)), vectors_(std::move(vectors)) {
  for (const MatVector& vector : vectors_) {
    names_.push_back(vector.name);
    units_.push_back(vector.unit);
  }
  NumberColumns();
}

void RecordedTable::NumberColumns() {
  for (std::size_t column = 0; column < names_.size(); ++column) columns_.emplace(names_[column], column);
}

std::optional<std::size_t> RecordedTable::FindColumn(std::string_view name) const {
  const auto found = columns_.find(std::string(name));
  return found == columns_.end() ? std::nullopt : std::optional(found->second);
}

bool RecordedTable::HoldsText(std::size_t column) const { return !csv_ && !vectors_[column].texts.empty(); }

bool RecordedTable::CheckColumns(std::span<const std::string_view> required, std::span<const std::string_view> optional,
                                 Diagnostics& diagnostics) const {
  bool good = true;
  const auto fault = [&](const Finding& kind, const std::vector<std::string>& words) {
    diagnostics.Report(kind, {file_, names_line()}, words);
    good = false;
  };
  for (const std::string_view name : required)
    if (!FindColumn(name)) fault(kColumnMissing, {std::string(name)});
  std::vector<std::string_view> legal(required.begin(), required.end());
  legal.insert(legal.end(), optional.begin(), optional.end());
  for (std::size_t column = 0; column < names_.size(); ++column) {
    const std::string& name = names_[column];
    if (rows(column) != rows(0))
      fault(kColumnLength, {name, std::to_string(rows(column)), names_.front(), std::to_string(rows(0))});
    if (std::find(legal.begin(), legal.end(), name) != legal.end()) continue;
    const std::string suggestion = DidYouMean(name, legal);
    if (suggestion.empty()) fault(kColumnSuperfluous, {name});
    else fault(kColumnUnknown, {name, suggestion});
  }
  return good;
}

std::string RecordedTable::RowInWords(std::size_t row) const {
  return csv_ ? "line " + std::to_string(line(row)) : "row " + std::to_string(row + 1);
}

void RecordedTable::Report(const Finding& kind, std::size_t row, const std::vector<std::string>& words,
                           Diagnostics& diagnostics) const {
  Diagnostics found;
  found.Report(kind, {file_, line(row)}, words);
  Diagnostic finding = found.items().front();
  if (!csv_) finding.message.insert(0, RowInWords(row) + ": ");
  diagnostics.Add(std::move(finding));
}

std::size_t RecordedTable::rows(std::size_t column) const {
  if (csv_) return csv_->rows();
  return std::max(vectors_[column].values.size(), vectors_[column].texts.size());
}

std::optional<double> RecordedTable::Number(std::size_t row, std::size_t column) const {
  if (csv_) return csv_->Number(row, column);
  if (HoldsText(column)) return std::nullopt;
  const double number = vectors_[column].values[row];
  return std::isinf(number) ? std::nullopt : std::optional(number);
}

std::string RecordedTable::Text(std::size_t row, std::size_t column) const {
  if (csv_) return csv_->Text(row, column);
  return HoldsText(column) ? vectors_[column].texts[row] : FormatNumber(vectors_[column].values[row]);
}

std::string RecordedTable::WhereUnitsStand(const std::string& name, const std::string& such) const {
  if (csv_) return "in a line below the names, or behind the name, as in '" + name + " [" + such + "]'";
  return "as a text '" + name + "_unit' in the file";
}

std::optional<RecordedTable> ReadRecordedTable(const std::filesystem::path& file, Diagnostics& diagnostics,
                                               CsvHeader header) {
  if (!IsMatFile(file)) {
    std::optional<CsvTable> csv = ReadCsv(file, diagnostics, header);
    if (!csv) return std::nullopt;
    return RecordedTable(*std::move(csv));
  }
  std::optional<std::vector<MatVector>> vectors = ReadMatFile(file, diagnostics);
  if (!vectors) return std::nullopt;
  return RecordedTable(file.string(), *std::move(vectors));
}

}  // namespace fourpost
