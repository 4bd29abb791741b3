#include "identify/experiments/bench/bench_report.h"

#include <array>
#include <vector>

#include "analysis/report/html.h"
#include "analysis/report/picture_number.h"
#include "identify/experiments/preparations_html.h"
#include "identify/experiments/run_history.h"
#include "identify/experiments/shared_curves.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kForces = "bench.csv";
constexpr const char* kEquivalents = "cycles.csv";

/// Of each recording its cycles, a list per column of the file.
Json EquivalentsJson(const std::string& text, const std::string& file) {
  Json list = Json::array();
  for (const TimeTable& table : ReadHistories(text, file, CsvHeader::kNames)) {
    Json recording = {{"recording", table.recording}};
    for (const TableColumn& column : table.columns) recording[column.name] = PictureNumbers(column.values);
    list.push_back(std::move(recording));
  }
  return list;
}

class CycleData : public ExperimentData {
 public:
  explicit CycleData(const RunFolder& run)
      : preparations_(PreparationsHtml(ListAt(run.result, "integration"), "recording")) {
    if (const std::string* text = run.Find(kForces))
      recordings_ = HistoriesJson(*text, run.FileNamed(kForces), CsvHeader::kNames);
    if (const std::string* text = run.Find(kEquivalents))
      equivalents_ = EquivalentsJson(*text, run.FileNamed(kEquivalents));
  }

  bool empty() const override { return recordings_.empty(); }
  bool IsOnPosts() const override { return false; }
  Json Drawn() const override { return {{"bench", recordings_}, {"equivalents", equivalents_}}; }

  std::vector<ReportSection> Sections() const override {
    return {{"bench", "Damper bench",
             preparations_ +
                 html::Drawn("bench", "The charts need JavaScript; bench.csv beside this file has their numbers."),
             true}};
  }

 private:
  std::string preparations_;
  Json recordings_ = Json::array();
  Json equivalents_ = Json::array();
};

Json SharedForces(std::span<const RunFolder> runs) {
  std::vector<std::vector<TimeTable>> tables(runs.size());
  std::vector<std::vector<TimedChannel>> of_runs(runs.size());
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::string* text = runs[r].Find(kForces);
    if (text == nullptr) continue;
    tables[r] = ReadHistories(*text, runs[r].FileNamed(kForces), CsvHeader::kNames);
    for (const TimeTable& table : tables[r])
      AddChannel(table, "force", "time_s", "measured_N", "modelled_N", of_runs[r]);
  }
  const auto describe = [](const TimedChannel& first, const std::set<std::size_t>& rows) -> Json {
    Json columns = Json::array();
    for (const TableColumn& column : first.table->columns)
      if (&column != first.modelled) columns.push_back({{"name", column.name}, {"values", ShownValues(column, rows)}});
    return {{"columns", std::move(columns)}};
  };
  return SharedOverTime(of_runs, runs, describe);
}

class DamperReport : public ExperimentReport {
 public:
  std::string_view Name() const override { return "damper bench"; }
  std::vector<std::string> Files() const override { return {kForces, kEquivalents}; }
  bool IsIn(const RunFolder& run) const override { return run.Find(kForces) != nullptr; }
  std::unique_ptr<ExperimentData> Read(const RunFolder& run) const override { return std::make_unique<CycleData>(run); }

  void EraseUnseen(nlohmann::json& study) const override {
    constexpr std::array<const char*, 3> kPlaces = {"damper", "recordings", "validation"};
    if (study.contains("bench")) EraseKeys(study["bench"], kPlaces);
  }

  std::vector<ComparedCurves> Compare(std::span<const RunFolder> runs) const override {
    return {{"bench", "Damper bench", SharedForces(runs)}};
  }
};

}  // namespace

const ExperimentReport& BenchReport() {
  static const DamperReport report;
  return report;
}

}  // namespace fourpost
