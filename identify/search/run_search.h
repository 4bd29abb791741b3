#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "identify/search/archive.h"
#include "identify/search/search_method.h"
#include "identify/search/stop_rules.h"

namespace fourpost {

/// One generation of the log; counts are totals of this search.
struct SearchGeneration {
  /// 0 is the initial population.
  int generation = 0;
  /// Infinite until an evaluation succeeds.
  double best_cost = 0;
  std::int64_t paid = 0;
  std::int64_t reused = 0;
  std::int64_t failed = 0;
  double diversity = 0;
  bool accelerated = false;
  bool migrated = false;

  bool operator==(const SearchGeneration&) const = default;
};

/// What the accelerations or the migrations of a search took and brought.
struct SearchGain {
  int count = 0;
  std::int64_t evaluations = 0;
  /// Those that lowered the best cost: an acceleration by itself, a migration before the next one.
  int successes = 0;
  /// Best cost after over best cost before, multiplied over all of them; 1 without a success.
  double cost_ratio = 1;

  SearchGain& operator+=(const SearchGain& other);
  bool operator==(const SearchGain&) const = default;
};

struct SearchResult {
  SearchEnd end = SearchEnd::kNotRun;
  /// The rule that ended the search, with its numbers: "evaluations used up: 300 of 300".
  std::string reason;
  /// Distinct good points, best first; empty when every evaluation failed.
  std::vector<Candidate> candidates;
  std::vector<SearchGeneration> log;
  SearchGain accelerations;
  SearchGain migrations;

  /// Throws std::logic_error when every evaluation failed.
  const Candidate& best() const;
};

/// What a search reports and asks while it runs, from the calling thread.
struct SearchHooks {
  /// After each generation.
  std::function<void(const SearchGeneration&)> progress;
  /// Before each batch of evaluations; true ends the search with what it has.
  std::function<bool()> stop;
  /// For methods that accelerate by derivatives: from these values to better ones, unless `stop` says to end.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& values, const std::function<bool()>& stop)> refine;
};

/// Which good points of the archive to report as candidates.
struct CandidateRules {
  int count = 5;
  /// How far apart: share of the range in at least one parameter; in [0, 1).
  double separation = 0.05;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

/// Runs a method until a rule ends it. Points in the archive already cost nothing.
/// Throws std::invalid_argument for rules out of bounds.
SearchResult RunSearch(Archive& archive, SearchMethod& method, const StopRules& rules, const CandidateRules& candidates,
                       const SearchHooks& hooks = {});

}  // namespace fourpost
