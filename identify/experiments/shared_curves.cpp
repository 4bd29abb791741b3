#include "identify/experiments/shared_curves.h"

#include <cmath>
#include <map>

#include "analysis/report/picture_number.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// Of a channel over time: some kB for each run.
constexpr std::size_t kMostRows = 3000;

/// A stretch of time [s].
struct Stretch {
  double from = 0;
  double to = 0;
};

/// About the largest measured value: an eighth of the recording, at most 2 s and kMostRows / 2 rows,
/// so that a page can show it row by row.
Stretch BusiestOf(const TimedChannel& channel) {
  constexpr double kMost_s = 2;
  const std::vector<double>& time = channel.time->values;
  const std::vector<double>& measured = channel.measured->values;
  const auto size = [](double value) { return std::isfinite(value) ? std::abs(value) : 0.0; };
  const auto peak =
      std::max_element(measured.begin(), measured.end(), [&](double a, double b) { return size(a) < size(b); });
  const double whole = time.back() - time.front();
  const double rows = static_cast<double>(kMostRows) / 2 / static_cast<double>(time.size());
  const double span = std::min({kMost_s, whole / 8, whole * rows});
  const double middle = time[static_cast<std::size_t>(peak - measured.begin())];
  const double from = std::clamp(middle - span / 2, time.front(), time.back() - span);
  return {from, from + span};
}

/// Thinned to the extremes, but whole in a stretch of time.
std::set<std::size_t> ShownRows(const Shared<TimedChannel>& shared, const Stretch& whole) {
  const TimedChannel& first = *shared.front().item;
  std::vector<const TableColumn*> columns = {first.measured};
  for (const auto& [run, channel] : shared) columns.push_back(channel->modelled);
  std::set<std::size_t> rows = RowsToShow(columns, first.table->rows, kMostRows);
  for (std::size_t row = 0; row < first.time->values.size(); ++row)
    if (first.time->values[row] >= whole.from && first.time->values[row] <= whole.to) rows.insert(row);
  return rows;
}

}  // namespace

bool AreAlike(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double kDigits = 1e-6;
  if (a.size() != b.size()) return false;
  double size = 0;
  for (const double value : a)
    if (std::isfinite(value)) size = std::max(size, std::abs(value));
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::isfinite(a[i]) != std::isfinite(b[i]) || std::abs(a[i] - b[i]) > kDigits * size) return false;
  return true;
}

void AddChannel(const TimeTable& table, const std::string& name, const std::string& time, const std::string& measured,
                const std::string& modelled, std::vector<TimedChannel>& channels) {
  const TimedChannel channel{&table, name, table.Find(time), table.Find(measured), table.Find(modelled)};
  if (channel.time != nullptr && channel.measured != nullptr && channel.modelled != nullptr)
    channels.push_back(channel);
}

Json SharedOverTime(const std::vector<std::vector<TimedChannel>>& of_runs, std::span<const RunFolder> runs,
                    const DescribeChannel& describe) {
  const auto is_same = [](const TimedChannel& a, const TimedChannel& b) {
    return a.table->recording == b.table->recording && a.name == b.name && AreAlike(a.time->values, b.time->values) &&
           AreAlike(a.measured->values, b.measured->values);
  };
  std::vector<std::vector<std::string>> fitted;
  for (const RunFolder& run : runs) fitted.push_back(FittedRecordings(run.result));
  // One stretch for all channels of a recording.
  std::map<std::string, Stretch> busiest;
  Json list = Json::array();
  for (const Shared<TimedChannel>& shared : SharedOf(of_runs, is_same)) {
    const TimedChannel& first = *shared.front().item;
    const Stretch whole = busiest.try_emplace(first.table->recording, BusiestOf(first)).first->second;
    const std::set<std::size_t> rows = ShownRows(shared, whole);
    Json lines = Json::array();
    for (const auto& [run, channel] : shared) {
      const bool is_fitted =
          std::find(fitted[run].begin(), fitted[run].end(), first.table->recording) != fitted[run].end();
      lines.push_back({{"run", run}, {"fitted", is_fitted}, {"values", ShownValues(*channel->modelled, rows)}});
    }
    Json json = {{"recording", first.table->recording},
                 {"busiest", {PictureNumber(whole.from), PictureNumber(whole.to)}}};
    json.update(describe(first, rows));
    json.update({{"runs", std::move(lines)}, {"rows", first.table->rows}, {"shown_rows", rows.size()}});
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace fourpost
