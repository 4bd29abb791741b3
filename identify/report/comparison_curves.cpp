#include "identify/report/comparison_curves.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <Eigen/Core>

#include "analysis/files/csv.h"
#include "identify/report/fitted_data.h"
#include "identify/report/history_table.h"
#include "identify/report/picture_number.h"
#include "identify/report/response_table.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// Of a channel over time: some kB for each run.
constexpr std::size_t kMostRows = 3000;

/// Of a run, by its number.
template <typename Item>
struct OfRun {
  std::size_t run = 0;
  const Item* item = nullptr;
};

/// What several runs have alike: the first decides what was measured.
template <typename Item>
using Shared = std::vector<OfRun<Item>>;

/// Numbers of files, which write all digits; of another version, perhaps fewer.
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

/// Items that are the same by `is_same`, in the order in which they come; those of one run alone left out.
template <typename Item, typename IsSame>
std::vector<Shared<Item>> SharedOf(const std::vector<std::vector<Item>>& of_runs, const IsSame& is_same) {
  std::vector<Shared<Item>> all;
  for (std::size_t run = 0; run < of_runs.size(); ++run)
    for (const Item& item : of_runs[run]) {
      const auto found = std::find_if(all.begin(), all.end(), [&](const Shared<Item>& shared) {
        return shared.back().run != run && is_same(*shared.front().item, item);
      });
      if (found == all.end()) all.push_back({{run, &item}});
      else found->push_back({run, &item});
    }
  std::erase_if(all, [](const Shared<Item>& shared) { return shared.size() < 2; });
  return all;
}

Json Numbers(const std::vector<double>& values) {
  return PictureNumbers(Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
}

bool HasNumbers(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// Null where the run has none.
const std::map<std::string, std::string>::value_type* FindFile(const ComparedRun& run, const std::string& name) {
  const auto file = run.contents.files.find(name);
  return file == run.contents.files.end() ? nullptr : &*file;
}

Json ResponsesJson(const std::vector<ComparedRun>& runs) {
  std::vector<std::vector<ComparedChannel>> of_runs(runs.size());
  for (std::size_t r = 0; r < runs.size(); ++r)
    if (const auto* file = FindFile(runs[r], "response.csv"))
      of_runs[r] = ReadResponseTable(file->second, runs[r].FileNamed(file->first));
  const auto is_same = [](const ComparedChannel& a, const ComparedChannel& b) {
    return a.recording == b.recording && a.name == b.name && AreAlike(a.frequency_Hz, b.frequency_Hz) &&
           AreAlike(a.gain_measured, b.gain_measured) && AreAlike(a.phase_measured_deg, b.phase_measured_deg);
  };
  Json list = Json::array();
  for (const Shared<ComparedChannel>& shared : SharedOf(of_runs, is_same)) {
    const ComparedChannel& first = *shared.front().item;
    const bool has_mean = HasNumbers(first.mean_measured);
    Json lines = Json::array();
    for (const auto& [run, channel] : shared) {
      lines.push_back(
          {{"run", run}, {"gain", Numbers(channel->gain_modelled)}, {"phase", Numbers(channel->phase_modelled_deg)}});
      if (has_mean) lines.back()["mean"] = Numbers(channel->mean_modelled);
    }
    list.push_back({{"recording", first.recording},
                    {"name", first.name},
                    {"unit", first.unit},
                    {"frequency_Hz", Numbers(first.frequency_Hz)},
                    {"gain_measured", Numbers(first.gain_measured)},
                    {"gain_sd", Numbers(first.gain_sd)},
                    {"phase_measured", Numbers(first.phase_measured_deg)},
                    {"phase_sd", Numbers(first.phase_sd_deg)},
                    {"runs", std::move(lines)}});
    if (has_mean) list.back()["mean_measured"] = Numbers(first.mean_measured);
  }
  return list;
}

/// A channel over time, of a table.
struct TimedChannel {
  const TimeTable* table = nullptr;
  std::string name;
  const TimeColumn* time = nullptr;
  const TimeColumn* measured = nullptr;
  const TimeColumn* modelled = nullptr;
};

/// Where the table has all of these columns.
void AddChannel(const TimeTable& table, const std::string& name, const std::string& time, const std::string& measured,
                const std::string& modelled, std::vector<TimedChannel>& channels) {
  const TimedChannel channel{&table, name, table.Find(time), table.Find(measured), table.Find(modelled)};
  if (channel.time != nullptr && channel.measured != nullptr && channel.modelled != nullptr)
    channels.push_back(channel);
}

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
  std::vector<const TimeColumn*> columns = {first.measured};
  for (const auto& [run, channel] : shared) columns.push_back(channel->modelled);
  std::set<std::size_t> rows = RowsToShow(columns, first.table->rows, kMostRows);
  for (std::size_t row = 0; row < first.time->values.size(); ++row)
    if (first.time->values[row] >= whole.from && first.time->values[row] <= whole.to) rows.insert(row);
  return rows;
}

/// What is known of a shared channel beside its lines, of the rows that are shown.
using Tell = std::function<Json(const TimedChannel& first, const std::set<std::size_t>& rows)>;

/// Thinned alike in all runs. `fitted`: of each run the recordings that it was fitted to.
Json SharedOverTime(const std::vector<std::vector<TimedChannel>>& of_runs,
                    const std::vector<std::vector<std::string>>& fitted, const Tell& tell) {
  const auto is_same = [](const TimedChannel& a, const TimedChannel& b) {
    return a.table->recording == b.table->recording && a.name == b.name && AreAlike(a.time->values, b.time->values) &&
           AreAlike(a.measured->values, b.measured->values);
  };
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
    json.update(tell(first, rows));
    json.update({{"runs", std::move(lines)}, {"rows", first.table->rows}, {"shown_rows", rows.size()}});
    list.push_back(std::move(json));
  }
  return list;
}

std::vector<std::vector<std::string>> FittedRecordingsOf(const std::vector<ComparedRun>& runs) {
  std::vector<std::vector<std::string>> fitted;
  for (const ComparedRun& run : runs) fitted.push_back(FittedRecordings(run.result));
  return fitted;
}

std::vector<TimedChannel> TimedChannels(const std::vector<TimeTable>& tables) {
  constexpr std::string_view kMeasured = "_measured";
  std::vector<TimedChannel> channels;
  for (const TimeTable& table : tables)
    for (const TimeColumn& column : table.columns) {
      if (!column.name.ends_with(kMeasured)) continue;
      const std::string name = column.name.substr(0, column.name.size() - kMeasured.size());
      AddChannel(table, name, "time", column.name, name + "_modelled", channels);
    }
  return channels;
}

Json SharedHistoriesJson(const std::vector<ComparedRun>& runs) {
  std::vector<std::vector<TimeTable>> tables(runs.size());
  std::vector<std::vector<TimedChannel>> of_runs;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    for (const char* name : {"history.csv", "validation.csv"}) {
      // A bench has none, and its results no files of that form.
      const auto* file = FindFile(runs[r], name);
      if (file == nullptr) continue;
      std::vector<TimeTable> read = ReadHistories(file->second, runs[r].FileNamed(file->first));
      std::move(read.begin(), read.end(), std::back_inserter(tables[r]));
    }
    of_runs.push_back(TimedChannels(tables[r]));
  }
  const auto tell = [](const TimedChannel& first, const std::set<std::size_t>& rows) -> Json {
    return {{"name", first.name},
            {"unit", first.measured->unit},
            {"time", ShownValues(*first.time, rows)},
            {"measured", ShownValues(*first.measured, rows)}};
  };
  return SharedOverTime(of_runs, FittedRecordingsOf(runs), tell);
}

Json BenchJson(const std::vector<ComparedRun>& runs) {
  std::vector<std::vector<TimeTable>> tables(runs.size());
  std::vector<std::vector<TimedChannel>> of_runs(runs.size());
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto* file = FindFile(runs[r], "bench.csv");
    if (file == nullptr) continue;
    tables[r] = ReadHistories(file->second, runs[r].FileNamed(file->first), CsvHeader::kNames);
    for (const TimeTable& table : tables[r])
      AddChannel(table, "force", "time_s", "measured_N", "modelled_N", of_runs[r]);
  }
  const auto tell = [](const TimedChannel& first, const std::set<std::size_t>& rows) -> Json {
    Json told = Json::array();
    for (const TimeColumn& column : first.table->columns)
      if (&column != first.modelled) told.push_back({{"name", column.name}, {"values", ShownValues(column, rows)}});
    return {{"columns", std::move(told)}};
  };
  return SharedOverTime(of_runs, FittedRecordingsOf(runs), tell);
}

/// The band [Hz] in which a run was fitted; null where it has none.
Json BandOf(const ComparedRun& run) {
  const std::vector<nlohmann::json> band = ListAt(run.result, "band_Hz");
  if (band.size() != 2 || !band[0].is_number() || !band[1].is_number() || !(band[1].get<double>() > 0)) return nullptr;
  return {PictureNumber(band[0].get<double>()), PictureNumber(band[1].get<double>())};
}

}  // namespace

Json ComparisonCurves(const std::vector<ComparedRun>& runs) {
  Json names = Json::array();
  Json bands = Json::array();
  for (const ComparedRun& run : runs) {
    names.push_back(run.name);
    bands.push_back(BandOf(run));
  }
  return {{"runs", std::move(names)},
          {"bands", std::move(bands)},
          {"responses", ResponsesJson(runs)},
          {"histories", SharedHistoriesJson(runs)},
          {"bench", BenchJson(runs)}};
}

}  // namespace fourpost
