#include "identify/experiments/time_history/history_report.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "analysis/report/html.h"
#include "identify/experiments/preparations_html.h"
#include "identify/experiments/run_history.h"
#include "identify/experiments/shared_curves.h"
#include "identify/experiments/time_history/motion_file.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFittedFile = "history.csv";
constexpr const char* kUnseenFile = "validation.csv";
constexpr const char* kMotionFile = "motion.csv";
constexpr std::string_view kMeasuredEnding = "_measured";

Json DrawnOf(const RunFolder& run, const char* file) {
  const std::string* text = run.Find(file);
  return text == nullptr ? Json::array() : HistoriesJson(*text, run.FileNamed(file));
}

/// Those of a cost that weighs by the errors of each output have no deviations.
bool IsCompromise(const nlohmann::json& result) { return TextAt(result, "history_cost") == "compromise"; }

class HistoryData : public ExperimentData {
 public:
  explicit HistoryData(const RunFolder& run)
      : run_(run), fitted_(DrawnOf(run, kFittedFile)), unseen_(DrawnOf(run, kUnseenFile)) {}

  bool empty() const override { return fitted_.empty() && unseen_.empty(); }
  Json Drawn() const override { return {{"histories", fitted_}, {"validation", unseen_}}; }

  std::vector<ReportSection> Sections() const override {
    return {{"histories", "Time histories",
             PreparationsHtml(ListAt(run_.result, "histories"), "recording") +
                 html::Drawn("histories",
                             "The charts need JavaScript; history.svg and validation.svg beside this file show them."),
             true}};
  }

  ReportRemarks Remarks() const override {
    ReportRemarks remarks;
    remarks.modelled = ListAt(run_.result, "histories");
    if (!IsCompromise(run_.result)) return remarks;
    remarks.why_no_deviations =
        "The compromise cost weighs each output by its own error and not by noise, so there are no "
        "standard deviations. Fit with the cost 'whitened' for them.";
    remarks.where_not_weighed =
        "The compromise cost does not weigh residuals by noise. Fit with the cost 'whitened' to see whether something "
        "is missing.";
    return remarks;
  }

  void AddMotions(const Vehicle& vehicle, RecordedMotions& motions) const override {
    if (const std::string* text = run_.Find(kMotionFile))
      motions.over_time = ReadMotionCsv(*text, run_.FileNamed(kMotionFile), vehicle);
  }

 private:
  RunFolder run_;
  Json fitted_;
  Json unseen_;
};

std::vector<TimedChannel> TimedChannels(const std::vector<TimeTable>& tables) {
  std::vector<TimedChannel> channels;
  for (const TimeTable& table : tables)
    for (const TableColumn& column : table.columns) {
      if (!column.name.ends_with(kMeasuredEnding)) continue;
      const std::string name = column.name.substr(0, column.name.size() - kMeasuredEnding.size());
      AddChannel(table, name, "time", column.name, name + "_modelled", channels);
    }
  return channels;
}

Json SharedHistories(std::span<const RunFolder> runs) {
  std::vector<std::vector<TimeTable>> tables(runs.size());
  std::vector<std::vector<TimedChannel>> of_runs;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    for (const char* name : {kFittedFile, kUnseenFile}) {
      const std::string* text = runs[r].Find(name);
      if (text == nullptr) continue;
      std::vector<TimeTable> read = ReadHistories(*text, runs[r].FileNamed(name));
      std::move(read.begin(), read.end(), std::back_inserter(tables[r]));
    }
    of_runs.push_back(TimedChannels(tables[r]));
  }
  const auto describe = [](const TimedChannel& first, const std::set<std::size_t>& rows) -> Json {
    return {{"name", first.name},
            {"unit", first.measured->unit},
            {"time", ShownValues(*first.time, rows)},
            {"measured", ShownValues(*first.measured, rows)}};
  };
  return SharedOverTime(of_runs, runs, describe);
}

class OverTimeReport : public ExperimentReport {
 public:
  std::string_view Name() const override { return "time histories"; }
  std::vector<std::string> Files() const override { return {kFittedFile, kUnseenFile, kMotionFile}; }

  /// Not where they are all kept for validation.
  bool IsIn(const RunFolder& run) const override { return run.Find(kFittedFile) != nullptr; }

  std::unique_ptr<ExperimentData> Read(const RunFolder& run) const override {
    return std::make_unique<HistoryData>(run);
  }

  nlohmann::json FittedData(const nlohmann::json& result) const override { return TextAt(result, "history_cost"); }

  void EraseUnseen(nlohmann::json& study) const override {
    if (!study.contains("histories")) return;
    study["histories"] = FittedEntries(study["histories"]);
    if (study["histories"].empty()) study.erase("histories");
  }

  std::vector<ComparedCurves> Compare(std::span<const RunFolder> runs) const override {
    return {{"histories", "Time histories", SharedHistories(runs)}};
  }
};

}  // namespace

const ExperimentReport& HistoryReport() {
  static const OverTimeReport report;
  return report;
}

}  // namespace fourpost
