#include "identify/experiments/experiment_report.h"

#include <array>
#include <iterator>

namespace fourpost {

void AddRemarks(ReportRemarks part, ReportRemarks& whole) {
  const auto fill = [&](std::string ReportRemarks::*text) {
    if ((whole.*text).empty()) whole.*text = std::move(part.*text);
  };
  whole.measures_force |= part.measures_force;
  whole.is_wiring_cleared |= part.is_wiring_cleared;
  fill(&ReportRemarks::missing_force);
  fill(&ReportRemarks::why_no_deviations);
  fill(&ReportRemarks::where_open);
  fill(&ReportRemarks::where_not_weighed);
  std::move(part.further.begin(), part.further.end(), std::back_inserter(whole.further));
  std::move(part.modelled.begin(), part.modelled.end(), std::back_inserter(whole.modelled));
}

void EraseKeys(nlohmann::json& object, std::span<const char* const> keys) {
  if (!object.is_object()) return;
  for (const char* key : keys) object.erase(key);
}

nlohmann::json FittedEntries(const nlohmann::json& recordings) {
  constexpr std::array<const char*, 2> kPlaces = {"file", "use"};
  nlohmann::json fitted = nlohmann::json::array();
  for (nlohmann::json recording : recordings) {
    if (recording.is_object() && recording.value("use", nlohmann::json()) == "validation") continue;
    EraseKeys(recording, kPlaces);
    fitted.push_back(std::move(recording));
  }
  return fitted;
}

}  // namespace fourpost
