#include <array>

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

/// What `fourpost report` makes of it; refusing is well.
template <typename MakePage>
void RequirePage(const MakePage& make) {
  try {
    const std::string page = make();
    Require(ValidUtf8(page) == page, "a page is UTF-8");
    const std::size_t first = page.find("</script");
    Require(page.find("</script", first + 1) == page.rfind("</script"), "a page has two scripts");
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
