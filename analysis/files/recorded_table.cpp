#include "analysis/files/recorded_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "analysis/files/findings.h"
#include "analysis/files/hdf5/hdf5_file.h"
#include "analysis/files/mat/mat_version5.h"
#include "analysis/files/mat/mat_version73.h"
#include "analysis/files/recorded_unit.h"
#include "analysis/files/recording/memory_recording.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/recording_format.h"
#include "analysis/files/response_functions.h"
#include "analysis/files/time_stamp.h"
#include "analysis/text/nearest.h"
#include "analysis/text/number.h"

namespace fourpost {
namespace {

/// False for what HDF5 cannot read, which is a fault of the HDF5 file then.
bool IsWrittenByMatlab(const std::filesystem::path& file) {
  try {
    return IsOfMatlab(file);
  } catch (const RecordingFault&) {
    return false;
  }
}

/// By its content, or of version 4 by its name.
bool IsMatFile(const std::filesystem::path& file) {
  const std::string head = FileHead(file);
  if (IsMatVersion5(head) || head.starts_with("MATLAB 7.3")) return true;
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".mat" ? !IsRecordingFile(file) || IsMatVersion73(head) : IsHdf5(head) && IsWrittenByMatlab(file);
}

}  // namespace

RecordedTable::RecordedTable(CsvTable csv) : file_(csv.file()), names_(csv.names()), units_(csv.units()) {
  units_.resize(names_.size());
  csv_ = std::move(csv);
  NumberColumns();
  ReadTimeStamps();
}

RecordedTable::RecordedTable(std::string file, std::vector<MatVector> vectors)
    : file_(std::move(file)), vectors_(std::move(vectors)) {
  for (const MatVector& vector : vectors_) {
    names_.push_back(vector.name);
    units_.push_back(vector.unit);
  }
  NumberColumns();
}

RecordedTable::RecordedTable(std::string file, RecordingColumns columns)
    : file_(std::move(file)), names_(columns.names()), units_(columns.units()), recording_(std::move(columns)) {
  NumberColumns();
}

void RecordedTable::ReadTimeStamps() {
  for (std::size_t column = 0; column < names_.size(); ++column) {
    const std::optional<TimeStamp> first = csv_->rows() == 0 ? std::nullopt : ParseTimeStamp(csv_->Text(0, column));
    if (!first) continue;
    std::vector<std::optional<double>>& seconds = stamps_s_[column];
    for (std::size_t row = 0; row < csv_->rows(); ++row) {
      const std::string& text = csv_->Text(row, column);
      const std::optional<TimeStamp> stamp = ParseTimeStamp(text);
      seconds.push_back(stamp          ? std::optional(stamp->After(*first))
                        : text.empty() ? std::optional(std::numeric_limits<double>::quiet_NaN())
                                       : std::nullopt);
    }
    units_[column] = "s";
  }
}

void RecordedTable::NumberColumns() {
  for (std::size_t column = 0; column < names_.size(); ++column) columns_.emplace(names_[column], column);
}

std::optional<std::size_t> RecordedTable::FindColumn(std::string_view name) const {
  const auto found = columns_.find(std::string(name));
  return found == columns_.end() ? std::nullopt : std::optional(found->second);
}

bool RecordedTable::HoldsText(std::size_t column) const { return !vectors_.empty() && !vectors_[column].texts.empty(); }

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
  if (recording_) return recording_->rows(column);
  return std::max(vectors_[column].values.size(), vectors_[column].texts.size());
}

std::optional<double> RecordedTable::Number(std::size_t row, std::size_t column) const {
  if (const auto stamps = stamps_s_.find(column); stamps != stamps_s_.end()) return stamps->second[row];
  if (csv_) return csv_->Number(row, column);
  if (HoldsText(column)) return std::nullopt;
  const double number = recording_ ? recording_->Column(column)[row] : vectors_[column].values[row];
  return std::isinf(number) ? std::nullopt : std::optional(number);
}

std::string RecordedTable::Text(std::size_t row, std::size_t column) const {
  if (csv_) return csv_->Text(row, column);
  if (HoldsText(column)) return vectors_[column].texts[row];
  return FormatNumber(recording_ ? recording_->Column(column)[row] : vectors_[column].values[row]);
}

std::string RecordedTable::WhereUnitsStand(const std::string& name, const std::string& such) const {
  if (csv_) return "in a line below the names, or behind the name, as in '" + name + " [" + such + "]'";
  if (recording_) return "as that of the channel in the file";
  return "as a text '" + name + "_unit' in the file";
}

namespace {

/// Of columns that read their file when they are asked for.
std::optional<RecordedTable> TableOf(std::shared_ptr<const RecordingFile> recording, const std::string& file,
                                     Diagnostics& diagnostics) {
  if (const auto* universal = dynamic_cast<const UniversalFile*>(recording.get());
      universal != nullptr && !universal->responses().empty()) {
    std::optional<std::vector<MatVector>> responses = SteppedSineOf(*universal, file, diagnostics);
    if (!responses) return std::nullopt;
    return RecordedTable(file, *std::move(responses));
  }
  Diagnostics found;
  RecordingColumns columns(std::move(recording), file, found);
  diagnostics.Add(found);
  if (found.HasErrors()) return std::nullopt;
  return RecordedTable(file, std::move(columns));
}

/// Of a text in which each channel has its times before it.
std::shared_ptr<const RecordingFile> WithTimesPerChannel(const CsvTable& csv, Diagnostics& diagnostics) {
  Recording recording;
  for (std::size_t column = 0; column < csv.columns(); column += 2) {
    const auto has_number = [&](std::size_t row) {
      return !csv.Text(row, column).empty() && !csv.Text(row, column + 1).empty();
    };
    const std::optional<Unit> unit = csv.units().empty() ? std::nullopt : ParseRecordedUnit(csv.units()[column]);
    RecordingChannel channel = {.name = csv.names()[column + 1],
                                .unit = csv.units().empty() ? "" : csv.units()[column + 1]};
    const std::vector<double> times = csv.Numbers(column, diagnostics);
    const std::vector<double> values = csv.Numbers(column + 1, diagnostics);
    for (std::size_t row = 0; row < csv.rows(); ++row) {
      // Channels of other lengths end with empty fields.
      if (!has_number(row)) continue;
      channel.times_s.push_back(times[row] * (unit && unit->dimension == kTime ? unit->si : 1));
      channel.values.push_back(values[row]);
    }
    if (!channel.values.empty()) recording.channels.push_back(std::move(channel));
  }
  return std::make_shared<MemoryRecording>(std::move(recording));
}

}  // namespace

std::optional<RecordedTable> ReadRecordedTable(const std::filesystem::path& file, Diagnostics& diagnostics,
                                               CsvHeader header) {
  const bool is_mat = IsMatFile(file);
  if (!is_mat && IsRecordingFile(file)) {
    std::shared_ptr<const RecordingFile> recording = OpenRecording(file, diagnostics);
    if (!recording) return std::nullopt;
    return TableOf(std::move(recording), file.string(), diagnostics);
  }
  if (!is_mat) {
    std::optional<CsvTable> csv = ReadCsv(file, diagnostics, header);
    if (!csv) return std::nullopt;
    if (!csv->has_times_per_channel()) return RecordedTable(*std::move(csv));
    Diagnostics faults;
    std::shared_ptr<const RecordingFile> recording = WithTimesPerChannel(*csv, faults);
    diagnostics.Add(faults);
    if (faults.HasErrors()) return std::nullopt;
    return TableOf(std::move(recording), file.string(), diagnostics);
  }
  std::optional<std::vector<MatVector>> vectors = ReadMatFile(file, diagnostics);
  if (!vectors) return std::nullopt;
  return RecordedTable(file.string(), *std::move(vectors));
}

}  // namespace fourpost
