#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "identify/refine/search_method_list.h"

namespace fourpost {

/// An optimiser that runs its own loop, as other people's do.
struct ForeignMethod {
  /// In words, for tables.
  std::vector<std::pair<std::string, std::string>> settings;
  /// Runs it on an archive until a rule ends it, or `stop` does. From several threads at once.
  std::function<SearchEnd(Archive& archive, std::uint64_t seed, const StopRules& rules,
                          const std::function<bool()>& stop)>
      run;
};

/// A method to compare, by the name it goes by in tables.
struct ComparedMethod {
  std::string name;
  MethodOptions options;
  /// In place of `options`.
  std::optional<ForeignMethod> foreign;
};

struct ComparisonOptions {
  int runs = 10;
  /// Of the first run; the others take the seeds after it.
  std::uint64_t seed = 1;
  /// Runs at once; 0: one per processor. No influence on the result.
  int threads = 1;
  /// With a target, a run ends there. Without, a run solves the problem when it comes within `near_best` of the best
  /// cost of all runs of all methods.
  StopRules rules;
  double near_best = 0.01;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

struct Interval {
  double lower = 0;
  double upper = 0;
};

/// A share of successes with its 95 % interval by Wilson's score (J. Am. Stat. Assoc. 22, 1927).
Interval WilsonInterval(std::int64_t successes, std::int64_t runs);

/// One run of a method.
struct RunOutcome {
  /// Evaluations until the target was reached, that one included, or else in all.
  std::int64_t evaluations = 0;
  bool solved = false;
  /// The best at the end; infinite when every evaluation failed.
  double cost = 0;
  /// Processor time that these evaluations took, of the whole run's in proportion, the method's own included; NaN with
  /// a store, which has evaluations for nothing.
  double seconds = 0;
};

/// What the runs of a method add up to.
struct MethodSummary {
  std::string name;
  /// What ran by that name, see AlgorithmName(); empty for a foreign one.
  std::string algorithm;
  std::vector<std::pair<std::string, std::string>> settings;
  std::vector<RunOutcome> outcomes;
  /// Of all runs.
  SearchGain accelerations;
  SearchGain migrations;
  std::int64_t successes = 0;
  Interval success_share;
  /// Over all runs, failures included.
  double evaluations_mean = 0;
  /// Evaluations of all runs over successes; infinite without a success. Interval: 2.5 and 97.5 % of 2000 bootstrap
  /// samples of the runs.
  double expected_evaluations = 0;
  Interval expected_interval;
  double cost_median = 0;
  double cost_worst = 0;
  /// How many runs each rule ended.
  std::map<SearchEnd, std::int64_t> ends;

  /// Over all runs, see RunOutcome::seconds.
  double MeanSeconds() const;
};

struct Comparison {
  double target_cost = 0;
  /// Of the problem.
  std::size_t parameters = 0;
  std::size_t residuals = 0;
  std::vector<MethodSummary> methods;
  /// Stopped by the user: unfinished runs are left out.
  bool interrupted = false;
};

struct ComparisonHooks {
  /// Runs finished, of how many; from any thread, one at a time.
  std::function<void(std::int64_t done, std::int64_t total)> progress;
  /// From any thread.
  std::function<bool()> stop;
};

/// Runs every method on the problem `runs` times, each run with an archive of its own. Equal for any number of threads,
/// unless a rule limits time, and with a `store` of the problem's evaluations that all runs share. Throws
/// std::invalid_argument for options out of bounds.
Comparison Compare(const Problem& problem, const std::vector<ComparedMethod>& methods, const ComparisonOptions& options,
                   const ComparisonHooks& hooks = {}, EvaluationStore* store = nullptr);

}  // namespace fourpost
