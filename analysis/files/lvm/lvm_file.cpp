#include "analysis/files/lvm/lvm_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "analysis/files/lvm/findings.h"
#include "analysis/files/recording/file_bytes.h"
#include "analysis/files/recording/file_lines.h"
#include "analysis/files/recording/findings.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/recording/unique_names.h"
#include "analysis/text/number.h"

namespace fourpost {
namespace {

constexpr std::string_view kEndOfHeader = "***End_of_Header***";
constexpr std::string_view kTimes = "X_Value";
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> Fields(std::string_view line, char separator) {
  std::vector<std::string> fields;
  for (;;) {
    const std::size_t end = std::min(line.find(separator), line.size());
    std::string_view field = line.substr(0, end);
    const std::size_t first = std::min(field.find_first_not_of(" \""), field.size());
    field = field.substr(first, field.find_last_not_of(" \"") + 1 - first);
    fields.emplace_back(field);
    if (end == line.size()) return fields;
    line.remove_prefix(end + 1);
  }
}

/// Keys and the fields behind them.
using LvmHeader = std::map<std::string, std::vector<std::string>>;

class LvmFile : public RecordingFile {
 public:
  explicit LvmFile(const std::filesystem::path& file) : bytes_(file, "LVM"), lines_(bytes_) {
    header_.format = "LVM";
    const LvmHeader all = ReadHeader();
    if (const auto found = all.find("Description"); found != all.end() && !found->second.empty())
      header_.description = found->second.front();
    while (ReadPart()) continue;
    if (header_.channels.empty()) throw RecordingFault(kRecordingNoChannel, {"LVM"});
    for (std::size_t i = 0; i < header_.channels.size(); ++i) SetTimes(i);
    MakeNamesUnique(header_);
  }

  std::vector<double> Values(std::size_t channel) const override { return values_[channel]; }

 protected:
  std::vector<double> ClockTimes(std::size_t channel) const override { return times_[channel]; }

 private:
  /// Up to its end.
  LvmHeader ReadHeader() {
    LvmHeader header;
    for (std::string_view line; lines_.Next(line);) {
      if (line.starts_with(kEndOfHeader)) return header;
      if (line.starts_with("Separator") && line.find("Comma") != std::string_view::npos) separator_ = ',';
      std::vector<std::string> fields = Fields(line, separator_);
      if (fields.front() == "Decimal_Separator" && fields.size() > 1 && fields[1] == ",") decimal_ = ',';
      const std::string key = fields.front();
      fields.erase(fields.begin());
      if (!key.empty()) header[key] = std::move(fields);
    }
    throw RecordingFault(kLvmHeader, {}, lines_.line());
  }

  std::optional<double> Number(std::string text) const {
    if (decimal_ == ',') std::replace(text.begin(), text.end(), ',', '.');
    return ParseNumber(text);
  }

  double Number(const LvmHeader& header, const std::string& key, std::size_t channel) const {
    const auto found = header.find(key);
    if (found == header.end() || found->second.empty()) return 0;
    return Number(found->second[std::min(channel, found->second.size() - 1)]).value_or(0);
  }

  /// A header and the rows behind it; false at the end.
  bool ReadPart() {
    std::string_view line;
    while (lines_.Next(line))
      if (Fields(line, separator_).front() == "Channels") break;
    if (!line.starts_with("Channels")) return false;
    LvmHeader header = ReadHeader();
    if (!lines_.Next(line)) throw RecordingFault(kLvmNames, {}, lines_.line());
    ReadNames(Fields(line, separator_), header);
    std::size_t row = 0;
    while (lines_.Next(line)) {
      const std::vector<std::string> fields = Fields(line, separator_);
      // A blank line ends a part.
      if (std::all_of(fields.begin(), fields.end(), [](const std::string& field) { return field.empty(); })) break;
      for (std::size_t i = 0; i < columns_.size(); ++i) AddSample(i, fields, row);
      ++row;
    }
    CheckSamples(header, row);
    return true;
  }

  /// Of the part that ends in `rows` rows: no fewer than its header has. There may be more, of packets that were
  /// written behind it without a header.
  void CheckSamples(const LvmHeader& header, std::size_t rows) const {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      std::size_t samples = rows;
      while (samples > 0 && std::isnan(values_[i][values_[i].size() - 1 - (rows - samples)])) --samples;
      const double stated = Number(header, "Samples", i);
      if (static_cast<double>(samples) < stated)
        throw RecordingFault(kLvmCutShort, {std::to_string(samples), columns_[i].name, FormatNumber(stated)},
                             lines_.line());
    }
  }

  void ReadNames(const std::vector<std::string>& names, const LvmHeader& header) {
    std::vector<Column> columns;
    std::optional<std::size_t> time;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == kTimes) time = i;
      else if (names[i] != "Comment" && !names[i].empty()) columns.push_back({names[i], i, time});
    }
    if (!columns_.empty() && columns.size() != columns_.size())
      throw RecordingFault(kLvmChannels, {std::to_string(columns.size()), std::to_string(columns_.size())},
                           lines_.line());
    if (columns_.empty()) AddChannels(columns, header);
    columns_ = std::move(columns);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      columns_[i].start = Number(header, "X0", i);
      columns_[i].step = Number(header, "Delta_X", i);
    }
  }

  struct Column {
    std::string name;
    std::size_t at = 0;
    /// Of its times.
    std::optional<std::size_t> time_at = std::nullopt;
    double start = 0;
    double step = 0;
  };

  void AddChannels(const std::vector<Column>& columns, const LvmHeader& header) {
    values_.resize(columns.size());
    times_.resize(columns.size());
    const auto units = header.find("Y_Unit_Label");
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const bool has_unit = units != header.end() && i < units->second.size();
      header_.channels.push_back({.name = columns[i].name, .unit = has_unit ? units->second[i] : ""});
      header_.channels.back().start_s = Number(header, "X0", i);
      header_.channels.back().step_s = std::max(Number(header, "Delta_X", i), 0.0);
    }
  }

  void AddSample(std::size_t i, const std::vector<std::string>& fields, std::size_t row) {
    const Column& column = columns_[i];
    const auto field = [&](std::size_t at) { return at < fields.size() ? fields[at] : std::string(); };
    const auto number = [&](std::size_t at) {
      const std::string text = field(at);
      const std::optional<double> value = text.empty() || text == "NaN" ? std::optional(kNaN) : Number(text);
      if (!value) throw RecordingFault(kLvmNumber, {text, column.name}, lines_.line());
      return *value;
    };
    const double even = column.start + column.step * static_cast<double>(row);
    const double time = column.time_at ? number(*column.time_at) : even;
    values_[i].push_back(number(column.at));
    times_[i].push_back(std::isnan(time) && column.step > 0 ? even : time);
  }

  /// Even ones where the step of the header agrees with all of them; channels with the same times share a clock.
  void SetTimes(std::size_t i) {
    RecordingChannel& channel = header_.channels[i];
    // Channels of other lengths end with empty fields.
    while (!values_[i].empty() && std::isnan(values_[i].back())) {
      values_[i].pop_back();
      times_[i].pop_back();
    }
    channel.samples = values_[i].size();
    const std::vector<double>& times = times_[i];
    bool is_even = channel.step_s > 0;
    for (std::size_t k = 0; k < times.size() && is_even; ++k)
      is_even = std::abs(times[k] - channel.start_s - channel.step_s * static_cast<double>(k)) < 0.5 * channel.step_s;
    if (is_even) return;
    channel.step_s = 0;
    const bool has_times = std::none_of(times.begin(), times.end(), [](double t) { return std::isnan(t); }) &&
                           (columns_[i].time_at || columns_[i].step > 0);
    if (!has_times) return;
    channel.clock = i;
    for (std::size_t other = 0; other < i; ++other)
      if (header_.channels[other].clock && times_[other] == times) channel.clock = header_.channels[other].clock;
  }

  FileBytes bytes_;
  FileLines lines_;
  char separator_ = '\t';
  char decimal_ = '.';
  /// Of the part that is read.
  std::vector<Column> columns_;
  /// By channel.
  std::vector<std::vector<double>> values_;
  std::vector<std::vector<double>> times_;
};

}  // namespace

std::unique_ptr<RecordingFile> OpenLvm(const std::filesystem::path& file) { return std::make_unique<LvmFile>(file); }

bool IsLvm(std::string_view head) { return head.starts_with("LabVIEW Measurement"); }

}  // namespace fourpost
