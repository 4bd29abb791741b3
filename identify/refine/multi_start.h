#pragma once

#include <cstdint>
#include <optional>

#include "identify/refine/refine.h"
#include "identify/search/archive.h"
#include "identify/search/cmaes.h"
#include "identify/search/dvhde.h"
#include "identify/search/run_search.h"

namespace fourpost {

/// What finds the optimum near a start.
enum class Descent {
  /// Levenberg-Marquardt on the residuals.
  kLevenbergMarquardt,
  /// BFGS on the cost alone.
  kQuasiNewton,
};

/// What looks for starts.
enum class Explorer { kEvolution, kCmaes };

/// Settings of a search by refinements.
struct MultiStartOptions {
  Descent descent = Descent::kLevenbergMarquardt;
  RefineOptions refine = {.step = 1e-5, .differences = Differences::kForward};
  /// Random points for each start, of which the best is refined; with `explore_evaluations` unused.
  int scouts = 1;
  /// Evaluations that the explorer spends before it hands over its best points, twice as many in each exploration after
  /// the first; 0: random points instead.
  std::int64_t explore_evaluations = 0;
  Explorer explorer = Explorer::kEvolution;
  /// Of Explorer::kEvolution.
  DvhdeOptions explore = PlainEvolution();
  /// Of Explorer::kCmaes.
  CmaesOptions explore_cmaes = {};
  /// Distinct good points refined after each exploration.
  int starts_each = 2;
  /// Refinements in all; 0: until a rule ends the search.
  int starts = 0;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

/// Refinements from random points or from those that an explorer finds, until a rule ends the search: target,
/// evaluations and time are looked at after each iteration. A refinement is a generation. `stop` is heeded as well.
/// Throws std::invalid_argument for options or rules out of bounds.
SearchResult RunMultiStart(Archive& archive, const MultiStartOptions& options, std::uint64_t seed,
                           const StopRules& rules, const CandidateRules& candidates, const SearchHooks& hooks = {});

}  // namespace fourpost
