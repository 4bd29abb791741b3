#include "analysis/time_recording.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/csv.h"
#include "analysis/nearest.h"
#include "analysis/number.h"

namespace fourpost {
namespace {

/// So many of a kind are told one by one.
constexpr int kMostFindings = 5;

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Rounded to what a file may tell.
std::string Seconds(double time_s) { return FormatNumber(std::round(1e9 * time_s), -9) + " s"; }

/// Reads one file; remembers whether all was well.
class RecordReader {
 public:
  RecordReader(const CsvTable& table, Diagnostics& diagnostics) : table_(table), diagnostics_(diagnostics) {}

  std::optional<TimeRecording> Read(std::span<const RecordedChannel> wanted) {
    const std::vector<double> times = Column({{"time"}, kTime, "the time of each sample"});
    TimeRecording recording;
    for (const RecordedChannel& channel : wanted) recording.channels.push_back(Column(channel));
    // Times that were no numbers have been told.
    if (times_good_) recording.step_s = Step(times);
    if (!good_) return std::nullopt;
    recording.start_s = times.front();
    recording.end_s = times.back();
    return recording;
  }

 private:
  void Fault(int line, const std::string& message) {
    diagnostics_.Error(table_.file(), line, message);
    good_ = false;
  }

  /// SI; empty where the column is not there.
  std::vector<double> Column(const RecordedChannel& channel) {
    for (const std::string& name : channel.names)
      if (const std::optional<std::size_t> column = table_.FindColumn(name)) return Values(*column, channel);
    const std::string& name = channel.names.front();
    Fault(1, "column '" + name + "', " + channel.what + ", is missing" + DidYouMean(name, table_.names()));
    if (name == "time") times_good_ = false;
    return {};
  }

  std::vector<double> Values(std::size_t column, const RecordedChannel& channel) {
    const std::string quoted = "column '" + table_.names()[column] + "'";
    const double si = UnitOf(column, channel, quoted);
    std::vector<double> values(table_.rows());
    int found = 0;
    for (std::size_t row = 0; row < table_.rows() && found < kMostFindings; ++row) {
      const std::optional<double> number = table_.Number(row, column);
      if (number && std::isfinite(*number)) {
        values[row] = *number * si;
        continue;
      }
      ++found;
      const std::string& text = table_.Text(row, column);
      Fault(table_.line(row), quoted + " has " + (text.empty() ? "no number" : "'" + text + "'") +
                                  " here; fill the gap or cut the record there");
    }
    if (found > 0 && table_.names()[column] == "time") times_good_ = false;
    return values;
  }

  double UnitOf(std::size_t column, const RecordedChannel& channel, const std::string& quoted) {
    const std::string& text = table_.units()[column];
    const std::optional<Unit> unit = ParseUnit(text);
    if (unit && unit->dimension == channel.dimension) return unit->si;
    Fault(2, quoted + ", " + channel.what + ", has '" + text + "' for its unit; it takes a " +
                 DimensionName(channel.dimension) + " such as '" +
                 (channel.dimension == kLength ? "mm" : SiUnit(channel.dimension)) + "' in the second line");
    return 1;
  }

  /// Of evenly spaced times.
  double Step(const std::vector<double>& times) {
    if (times.size() < 4) {
      Fault(0, "has " + std::to_string(times.size()) + " samples; it takes four at least");
      return 0;
    }
    std::vector<double> steps(times.size() - 1);
    for (std::size_t k = 0; k < steps.size(); ++k) steps[k] = times[k + 1] - times[k];
    const double usual = Median(steps);
    if (!(usual > 0)) {
      Fault(0, "column 'time' does not rise from sample to sample; write the time of each sample in its unit");
      return 0;
    }
    int found = 0;
    for (std::size_t k = 0; k < steps.size() && found < kMostFindings; ++k) {
      // Half a step is more than any rounding of times, and less than a sample that is lost.
      if (std::abs(steps[k] - usual) < 0.5 * usual) continue;
      ++found;
      Fault(table_.line(k + 1), "time goes from " + FormatNumber(times[k]) + " s to " + FormatNumber(times[k + 1]) +
                                    " s, else by " + Seconds(usual) +
                                    ": samples must be evenly spaced; fill the gap or cut the record there");
    }
    const double step = (times.back() - times.front()) / static_cast<double>(steps.size());
    if (found == 0) CheckGrid(times, step);
    return step;
  }

  /// Steps that each look well may still add up to another rate.
  void CheckGrid(const std::vector<double>& times, double step) {
    std::size_t worst = 0;
    const auto off = [&](std::size_t k) { return times[k] - times.front() - step * static_cast<double>(k); };
    for (std::size_t k = 0; k < times.size(); ++k)
      if (std::abs(off(k)) > std::abs(off(worst))) worst = k;
    if (std::abs(off(worst)) < 0.5 * step) return;
    Fault(table_.line(worst), "time is " + Seconds(off(worst)) + " off even steps of " + Seconds(step) +
                                  " here: samples must be evenly spaced; resample the record at one rate");
  }

  const CsvTable& table_;
  Diagnostics& diagnostics_;
  bool good_ = true;
  bool times_good_ = true;
};

}  // namespace

std::optional<TimeRecording> ReadTimeRecording(const std::filesystem::path& file,
                                               std::span<const RecordedChannel> wanted, Diagnostics& diagnostics) {
  const std::optional<CsvTable> table = ReadCsv(file, diagnostics, CsvHeader::kNamesAndUnits);
  if (!table) return std::nullopt;
  return RecordReader(*table, diagnostics).Read(wanted);
}

}  // namespace fourpost
