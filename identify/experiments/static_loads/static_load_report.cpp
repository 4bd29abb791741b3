#include "identify/experiments/static_loads/static_load_report.h"

#include <array>
#include <vector>

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

std::vector<nlohmann::json> LoadsOf(const nlohmann::json& result) { return ListAt(result, "static_loads"); }

std::string LoadTableHtml(const std::vector<nlohmann::json>& loads) {
  std::vector<std::vector<html::Cell>> rows;
  for (const nlohmann::json& load : loads) {
    const double measured = NumberAt(load, "measured_N");
    const double modelled = NumberAt(load, "modelled_N");
    rows.push_back({{html::Code(TextAt(load, "tyre")), ""},
                    html::NumberCell(ShownDecimals(measured, 0)),
                    SdCell(NumberAt(load, "sd_N"), 0),
                    html::NumberCell(ShownDecimals(modelled, 0)),
                    html::NumberCell(ShownDecimals(100 * (modelled / measured - 1), 2))});
  }
  return html::Table({"static load", "measured, N", "sd", "modelled, N", "error, %"}, rows);
}

class LoadData : public ExperimentData {
 public:
  explicit LoadData(const RunFolder& run) : loads_(LoadsOf(run.result)) {}

  bool empty() const override { return loads_.empty(); }
  std::vector<ReportSection> Sections() const override { return {{"loads", "Static loads", LoadTableHtml(loads_)}}; }
  ReportRemarks Remarks() const override { return {.measures_force = !loads_.empty()}; }

 private:
  std::vector<nlohmann::json> loads_;
};

class LoadReport : public ExperimentReport {
 public:
  std::string_view Name() const override { return "static loads"; }
  bool IsIn(const RunFolder& run) const override { return !LoadsOf(run.result).empty(); }
  std::unique_ptr<ExperimentData> Read(const RunFolder& run) const override { return std::make_unique<LoadData>(run); }

  /// The loads and their deviations.
  nlohmann::json FittedData(const nlohmann::json& result) const override {
    nlohmann::json loads = nlohmann::json::array();
    for (const nlohmann::json& load : LoadsOf(result))
      loads.push_back(
          {TextAt(load, "tyre"), load.value("measured_N", nlohmann::json()), load.value("sd_N", nlohmann::json())});
    return loads;
  }

  void EraseUnseen(nlohmann::json& study) const override {
    constexpr std::array<const char*, 1> kPlaces = {"file"};
    if (study.contains("static_loads")) EraseKeys(study["static_loads"], kPlaces);
  }
};

}  // namespace

const ExperimentReport& StaticLoadReport() {
  static const LoadReport report;
  return report;
}

}  // namespace fourpost
