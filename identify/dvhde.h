#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "identify/archive.h"
#include "identify/population.h"

namespace fourpost {

/// What a mutant starts from: a random member (DE/rand/1/bin) or the best one (DE/best/1/bin).
enum class MutationBase { kRandom, kBest };

/// The mutation factor: a constant; one random number in [0, 1) for all of a generation; or one for every gene of
/// every member (the thesis's random matrix).
enum class MutationFactor { kConstant, kPerGeneration, kPerGene };

/// Settings of dvHDE. The defaults are the most reliable of those tried on integer, mixed and smooth problems; on
/// smooth ones MutationBase::kBest with a factor of 0.7 needs fewer evaluations, and misses more often on the others.
struct DvhdeOptions {
  /// Equal seeds give equal results, for any number of threads.
  std::uint64_t seed = 1;

  int population = 40;
  MutationBase base = MutationBase::kRandom;
  MutationFactor factor_rule = MutationFactor::kConstant;
  /// For MutationFactor::kConstant; in (0, 2].
  double factor = 0.5;
  /// Probability of a gene from the mutant; in [0, 1].
  double crossover = 0.9;
  /// At least one gene comes from the mutant.
  bool forced_gene = true;

  /// Downhill-simplex iterations of an acceleration; 0 turns it off.
  int simplex_iterations = 5;
  /// Accelerate when the best cost fell by less than this share since the last generation; in [0, 1].
  double accelerate_below = 0.1;

  /// Migrate after this many generations without a better cost; 0 turns it off. Below about 100 it breaks off searches
  /// that still make progress on problems with many minima.
  int migrate_after = 100;
  /// Migrate when the diversity is below; in [0, 1], 0 turns it off. It keeps the population from settling anywhere
  /// finer than `gene_difference`, so it is off unless asked for.
  double migrate_below_diversity = 0;
  DiversityMeasure diversity_measure = DiversityMeasure::kRange;
  /// A gene counts as different when it is this far from the best one's; in (0, 1).
  double gene_difference = 0.05;

  /// Ends the search: paid evaluations (never exceeded; those of an earlier search with the archive do not count),
  /// generations, a cost to reach.
  std::int64_t max_evaluations = 10000;
  int max_generations = 1000;
  std::optional<double> target_cost;

  /// How many good points to report, and how far apart (share of the range in at least one parameter; in [0, 1)).
  int candidates = 5;
  double candidate_separation = 0.05;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

/// The thesis's settings for the Land Rover (ch. 5): 20 members, factor 0.7, crossover 0.8, migration below a diversity
/// of 0.1, acceleration below 10 %. The thesis does not say which base it used there (best, as its other continuous
/// problems suggest), when a search stagnates (150 generations, from its gear train), nor when to end (150 generations,
/// from its appendix A).
DvhdeOptions ThesisDvhde();

/// Which rule ended a search.
enum class SearchEnd { kNotRun, kTarget, kEvaluations, kGenerations, kStopped };

/// "target cost reached", ...
std::string_view SearchEndName(SearchEnd end);

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

struct SearchResult {
  SearchEnd end = SearchEnd::kNotRun;
  /// Distinct good points, best first; empty when every evaluation failed.
  std::vector<Candidate> candidates;
  std::vector<SearchGeneration> log;

  /// Throws std::logic_error when every evaluation failed.
  const Candidate& best() const;
};

/// What a search tells and asks while it runs, from the calling thread.
struct SearchHooks {
  /// After each generation.
  std::function<void(const SearchGeneration&)> progress;
  /// Before each batch of evaluations; true ends the search with what it has.
  std::function<bool()> stop;
};

/// Discrete-variable hybrid differential evolution (thesis ch. 2): differential evolution on lattice indices, with
/// acceleration by a downhill simplex and migration. Points in the archive already cost nothing.
/// Throws std::invalid_argument for options out of bounds.
SearchResult SearchDvhde(Archive& archive, const DvhdeOptions& options, const SearchHooks& hooks = {});

}  // namespace fourpost
