#include "identify/experiments/kinematics/kinematic_report.h"

#include <array>
#include <vector>

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

constexpr const char* kPicture = "kinematics.svg";

std::vector<nlohmann::json> CurvesOf(const nlohmann::json& result) { return ListAt(result, "kinematics"); }

std::string CurveTableHtml(const std::vector<nlohmann::json>& curves) {
  std::vector<std::vector<html::Cell>> rows;
  for (const nlohmann::json& curve : curves) {
    const std::string unit = TextAt(curve, "unit");
    const auto number = [&](const char* key) {
      return html::NumberCell(ShownNumber(NumberAt(curve, key), 3) + (unit.empty() ? "" : " " + unit));
    };
    rows.push_back(
        {html::TextCell(TextAt(curve, "recording") + (TextAt(curve, "use") == "validation" ? " (validation)" : "")),
         html::TextCell(TextAt(curve, "motion")),
         html::TextCell(TextAt(curve, "quantity")),
         {html::Code(TextAt(curve, "of")), ""},
         html::NumberCell(ShownDecimals(NumberAt(curve, "points"), 0)),
         number("rms"),
         number("noise"),
         html::NumberCell(ShownDecimals(NumberAt(curve, "misfit"), 2)),
         curve.contains("offset") ? number("offset") : html::NumberCell("")});
  }
  return html::Table({"table", "motion", "quantity", "of", "points", "rms error", "noise", "misfit", "fitted offset"},
                     rows);
}

class CurveData : public ExperimentData {
 public:
  explicit CurveData(const RunFolder& run) : curves_(CurvesOf(run.result)) {
    if (const std::string* svg = run.Find(kPicture)) picture_ = *svg;
  }

  bool empty() const override { return curves_.empty(); }
  bool IsOnPosts() const override { return false; }
  std::vector<ReportSection> Sections() const override {
    std::string html;
    if (!picture_.empty())
      html = html::Picture(picture_, "measured and modelled kinematics and compliance over travel and load");
    return {{"kinematics", "Kinematics and compliance", html + CurveTableHtml(curves_)}};
  }

 private:
  std::vector<nlohmann::json> curves_;
  std::string picture_;
};

class CurveReport : public ExperimentReport {
 public:
  std::string_view Name() const override { return "kinematics and compliance"; }
  std::vector<std::string> Files() const override { return {kPicture}; }
  bool IsIn(const RunFolder& run) const override { return !CurvesOf(run.result).empty(); }
  std::unique_ptr<ExperimentData> Read(const RunFolder& run) const override { return std::make_unique<CurveData>(run); }

  /// The curves and their weights.
  nlohmann::json FittedData(const nlohmann::json& result) const override {
    nlohmann::json data = nlohmann::json::array();
    for (const nlohmann::json& curve : CurvesOf(result))
      if (TextAt(curve, "use") != "validation")
        data.push_back({TextAt(curve, "recording"), TextAt(curve, "motion"), TextAt(curve, "quantity"),
                        TextAt(curve, "of"), curve.value("points", nlohmann::json()),
                        curve.value("noise", nlohmann::json())});
    return data;
  }

  void EraseUnseen(nlohmann::json& study) const override {
    constexpr std::array<const char*, 1> kPlaces = {"file"};
    if (!study.contains("kinematics") || !study["kinematics"].is_array()) return;
    for (nlohmann::json& table : study["kinematics"]) EraseKeys(table, kPlaces);
  }
};

}  // namespace

const ExperimentReport& KinematicReport() {
  static const CurveReport report;
  return report;
}

}  // namespace fourpost
