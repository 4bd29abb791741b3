#include "identify/run/growth_summary.h"

namespace fourpost {

GrowthSummary SummaryOf(const GrowthPath& path, const std::string& not_done) {
  return {.added = path.Added(),
          .taken_back = path.TakenBack(),
          .end = path.end.empty() ? "interrupted" : path.end,
          .not_done = not_done,
          .state = path.state,
          .steps = GrowthStepsJson(path)};
}

nlohmann::ordered_json GrownJson(const GrowthSummary& growth) {
  return {{"added", growth.added},       {"taken_back", growth.taken_back},
          {"end", growth.end},           {"interrupted", !growth.not_done.empty()},
          {"not_done", growth.not_done}, {"steps", growth.steps},
          {"state", growth.state}};
}

}  // namespace fourpost
