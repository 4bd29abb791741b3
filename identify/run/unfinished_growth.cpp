#include "identify/run/unfinished_growth.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "analysis/files/output_folder.h"
#include "analysis/files/text_file.h"
#include "identify/report/report_page.h"
#include "identify/run/findings.h"
#include "identify/run/growth_summary.h"
#include "identify/study/experiment_kinds.h"
#include "identify/study_file/warnings_json.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;

constexpr const char* kResultFile = "result.json";

/// But for the page, which is made anew, and the evaluations. Throws FaultyInput.
RunContents ContentsOf(const fs::path& folder) {
  RunContents run;
  Diagnostics faults;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file() || name == "report.html" || name.find(".sqlite") != std::string::npos ||
        name.ends_with(".partial"))
      continue;
    if (std::optional<std::string> text = ReadTextFile(entry.path(), faults)) run.files[name] = *std::move(text);
  }
  if (faults.HasErrors()) throw FaultyInput(faults);
  run.vehicle = ReadVehicle(folder / "vehicle.urdf", faults);
  if (!run.vehicle) throw FaultyInput(faults);
  return run;
}

}  // namespace

FitRun WriteUnfinishedGrowth(const fs::path& step, const fs::path& output, const GrowthSummary& growth, FitRun fit) {
  RunContents run = ContentsOf(step);
  Diagnostics conclusions;
  const std::string last = growth.added.empty() ? "nothing added" : growth.added.back();
  conclusions.Report(kGrowthInterrupted, {}, {std::to_string(growth.added.size()), last, growth.not_done});
  auto result = nlohmann::ordered_json::parse(run.files.at(kResultFile));
  result["growth"] = GrownJson(growth);
  for (const auto& one : WarningsJson(conclusions)) result["conclusions"].push_back(one);
  fit.json = run.files[kResultFile] = JsonText(result);
  fit.text += conclusions.Format() + '\n';
  OutputFolder folder(output, "archive.sqlite");
  for (const auto& [name, text] : run.files) folder.Add(name, text);
  folder.Add("report.html", ReportPage(run, AllExperimentReports()));
  folder.Commit();
  fit.is_written = true;
  return fit;
}

}  // namespace fourpost
