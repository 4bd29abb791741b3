#include <array>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "analysis/text/diagnostics.h"
#include "analysis/text/utf8.h"
#include "identify/report/comparison_page.h"
#include "identify/report/report_page.h"
#include "identify/study/experiment_kinds.h"
#include "tests/fuzz/fuzz_target.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

std::optional<Vehicle> StarterVehicle() {
  Diagnostics ignored;
  return ReadVehicle(std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies/starter/vehicle.urdf", ignored);
}

RunContents RunOf(const std::string& bytes) {
  constexpr std::array<const char*, 7> kNames = {"result.json",    "response.csv", "history.csv", "motion.csv",
                                                 "validation.csv", "bench.csv",    "study.yaml"};
  static const std::optional<Vehicle> vehicle = StarterVehicle();
  RunContents run{.vehicle = vehicle};
  std::size_t at = 0;
  for (const char* name : kNames) {
    const std::size_t end = std::min(bytes.find('\x1E', at), bytes.size());
    if (end > at) run.files[name] = bytes.substr(at, end - at);
    if (end == bytes.size()) break;
    at = end + 1;
  }
  return run;
}

std::size_t CountOf(std::string_view text, const std::string& page) {
  std::size_t count = 0;
  for (std::size_t at = page.find(text); at != std::string::npos; at = page.find(text, at + 1)) ++count;
  return count;
}

/// Data and program always; the packed engine and stage where a page has them, once each.
bool HasItsOwnScriptsAlone(const std::string& page) {
  const std::size_t engines = CountOf("<script type=\"application/wasm+base64\" id=\"program\">", page);
  const std::size_t stages = CountOf("<script type=\"text/javascript+base64\" id=\"stage\">", page);
  return engines <= 1 && stages <= 1 && CountOf("</script", page) == 2 + engines + stages;
}

/// What `fourpost report` makes of it; refusing is well.
template <typename MakePage>
void RequirePage(const MakePage& make) {
  try {
    const std::string page = make();
    Require(ValidUtf8(page) == page, "a page is UTF-8");
    Require(HasItsOwnScriptsAlone(page), "a page has no scripts but its own");
  } catch (const FaultyInput&) {
  } catch (const nlohmann::json::exception&) {
  }
}

}  // namespace

void FuzzResult(const std::string& bytes) {
  const RunContents run = RunOf(bytes);
  RequirePage([&] { return ReportPage(run, AllExperimentReports()); });
  RequirePage([&] { return ComparisonPage({{"a", run}, {"b", run}}, AllExperimentReports()); });
}

}  // namespace fourpost
