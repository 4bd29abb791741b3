#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

namespace fourpost {

/// When a search ends; the first rule that holds.
struct StopRules {
  /// Cost to reach.
  std::optional<double> target_cost;
  /// New evaluations, never exceeded by methods on the lattice; a refinement finishes its iteration. Those of an
  /// earlier search with the archive do not count.
  std::int64_t max_evaluations = 10000;
  int max_generations = 1000;
  /// Wall time [s], looked at before each batch: the one rule that makes results depend on the machine.
  double max_seconds = std::numeric_limits<double>::infinity();
  /// Generations without a better cost; 0 turns it off.
  int max_stagnant_generations = 0;
  /// Generations in a row without a new evaluation: the method asks only for what is known.
  int max_free_generations = 1000;
  /// End when all members are on one point and the method does not scatter them.
  bool on_collapse = true;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

/// Which rule ended a search.
enum class SearchEnd {
  kNotRun,
  kTarget,
  kEvaluations,
  kGenerations,
  kOutOfTime,
  kStagnation,
  kCollapse,
  kNothingNew,
  /// A method that ends by itself, as a refinement that converged.
  kFinished,
  kStopped,
};

/// "target cost reached", ...
std::string_view SearchEndName(SearchEnd end);

}  // namespace fourpost
