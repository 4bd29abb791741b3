#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/run/growth_path.h"

namespace fourpost {

/// Of a fit that grew, see GrowFit(): what its results say of that.
struct GrowthSummary {
  /// What stands and what was taken back, in words and in order.
  std::vector<std::string> added;
  std::vector<std::string> taken_back;
  /// Why it added no more, or that it was interrupted.
  std::string end;
  /// What the user's stop left to do: "the last fit with a search"; empty: nothing.
  std::string not_done;
  /// Digest of all that it depends on.
  std::string state;
  /// See GrowthStepsJson().
  nlohmann::ordered_json steps;
};

GrowthSummary SummaryOf(const GrowthPath& path, const std::string& not_done);

/// `growth` of result.json.
nlohmann::ordered_json GrownJson(const GrowthSummary& growth);

}  // namespace fourpost
