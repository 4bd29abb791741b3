#include "identify/search/stop_rules.h"

#include "analysis/text/option_check.h"

namespace fourpost {

void StopRules::Validate() const {
  RequireOption(!target_cost || *target_cost >= 0, "target_cost", target_cost.value_or(0), "0 or more");
  RequireOption(max_evaluations >= 1, "max_evaluations", max_evaluations, "1 or more");
  RequireOption(max_generations >= 0, "max_generations", max_generations, "0 or more");
  RequireOption(max_seconds > 0, "max_seconds", max_seconds, "above 0");
  RequireOption(max_stagnant_generations >= 0, "max_stagnant_generations", max_stagnant_generations, "0 or more");
  RequireOption(max_free_generations >= 1, "max_free_generations", max_free_generations, "1 or more");
}

std::string_view SearchEndName(SearchEnd end) {
  switch (end) {
    case SearchEnd::kNotRun: return "not run";
    case SearchEnd::kTarget: return "target cost reached";
    case SearchEnd::kEvaluations: return "evaluations used up";
    case SearchEnd::kGenerations: return "last generation reached";
    case SearchEnd::kOutOfTime: return "time used up";
    case SearchEnd::kStagnation: return "no better cost for too long";
    case SearchEnd::kCollapse: return "population collapsed";
    case SearchEnd::kNothingNew: return "nothing new to evaluate";
    case SearchEnd::kFinished: return "finished";
    case SearchEnd::kStopped: return "stopped by the user";
  }
  return "unknown";
}

}  // namespace fourpost
