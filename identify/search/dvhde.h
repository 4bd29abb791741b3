#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "identify/search/archive.h"
#include "identify/search/draws.h"
#include "identify/search/lattice_simplex.h"
#include "identify/search/population.h"
#include "identify/search/run_search.h"
#include "identify/search/search_method.h"

namespace fourpost {

/// What a mutant starts from: a random member (DE/rand/1/bin) or the best one (DE/best/1/bin).
enum class MutationBase { kRandom, kBest };

/// The mutation factor: a constant; one random number in [0, 1) for all of a generation; or one for every gene of
/// every member (the thesis's random matrix).
enum class MutationFactor { kConstant, kPerGeneration, kPerGene };

/// Settings of dvHDE.
struct DvhdeOptions {
  int population = 40;
  MutationBase base = MutationBase::kRandom;
  MutationFactor factor_rule = MutationFactor::kConstant;
  /// For MutationFactor::kConstant; in (0, 2].
  double factor = 0.5;
  /// Probability of a gene from the mutant; in [0, 1].
  double crossover = 0.9;
  /// At least one gene comes from the mutant.
  bool forced_gene = true;
  /// Rank infeasible points by their violation where the problem tells it; else all of them are alike.
  bool rank_violations = true;

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

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

/// dvHDE as the thesis has it for the Land Rover (ch. 5): 20 members, factor 0.7, crossover 0.8, migration below a
/// diversity of 0.1, acceleration below 10 %. Where the text is silent or in two minds, this is how it is read; "tried"
/// tells that the other readings were compared with the thesis's own success rates, to which the choice is then fitted:
/// - Base: not stated for ch. 5; the best member. Tried: the gear train's rates only come with a random base, the coil
///   spring's only with the best, the other continuous problems suggest the best.
/// - Crossover: "parent if rand > mu_c" with a remark of fifty-fifty. mu_c is the probability of the mutant's gene
///   (tried: the other way round the gear train is solved a third as often); the remark contradicts mu_c = 0.8.
/// - A gene forced from the mutant: not mentioned, so none. Tried: of four published rates two fit with it, two
///   without.
/// - Illegal genes: replaced by random legal ones, as written. Tried: clipping solves the gear train a fourth as often.
/// - Members that make a mutant: differ from each other and from the parent; selection needs a strictly lower cost.
///   Tried: immaterial.
/// - Constraints: a point that violates one has no cost at all (death penalty); nothing else is mentioned.
/// - Acceleration: 5 iterations of the downhill simplex, started from the best members, one more than parameters; not
///   stated. Its result takes the place of the worst member if it is better than the best: otherwise it is a copy.
/// - Migration: replaces all but the best member. Tried: competing one-to-one loses what the thesis gains by it.
/// - Diversity (eq. 2.8): relative to the index of the best one's gene, to the letter, though biased where that is
///   small; DiversityMeasure::kRange is the alternative.
/// - Stagnation: 150 generations without a better cost, the gear train's. Tried: below 100 the rates collapse.
DvhdeOptions ThesisDvhde();

/// Plain differential evolution: ThesisDvhde() without acceleration and migration.
DvhdeOptions PlainEvolution();

/// Discrete-variable hybrid differential evolution (thesis ch. 2): differential evolution on lattice indices, with
/// acceleration by a downhill simplex and migration.
class Dvhde : public SearchMethod {
 public:
  /// Equal seeds give equal searches. The lattice must outlive it.
  /// Throws std::invalid_argument for options out of bounds.
  Dvhde(const Lattice& lattice, const DvhdeOptions& options, std::uint64_t seed);

  const std::vector<LatticePoint>& Ask() const override;
  void Tell(const std::vector<Score>& scores) override;
  bool EndsGeneration() const override { return ends_generation_; }
  MethodState state() const override { return state_; }

  const Population& population() const { return population_; }

 private:
  enum class Stage { kInitial, kTrials, kSimplex, kMigrants };

  void AskInitial();
  void AskTrials();
  void AskMigrants();
  void Select(const std::vector<Score>& scores);
  void Accelerate();
  void EndAcceleration();
  void Migrate(const std::vector<Score>& scores);
  void EndEvolution();
  void EndGeneration();

  bool IsSlow() const;
  bool NeedsMigration() const;
  bool IsCollapsed() const;
  bool CanMigrate() const { return options_.migrate_after > 0 || options_.migrate_below_diversity > 0; }
  double CurrentDiversity() const;
  std::vector<double> Factors(double generation_factor, Draws& draws) const;
  Draws DrawsFor(DrawPurpose purpose, std::size_t individual) const;
  std::vector<Score> Ranked(std::vector<Score> scores) const;
  const Individual& Best() const { return population_[BestIndex(population_)]; }
  const LatticePoint& Point(std::size_t i) const { return population_[i].point; }

  const Lattice* lattice_;
  DvhdeOptions options_;
  std::uint64_t seed_;
  Stage stage_ = Stage::kInitial;
  Population population_;
  std::vector<LatticePoint> asked_;
  std::optional<LatticeSimplex> simplex_;
  // The best before this generation.
  Score previous_;
  // Generations without gain since then or since the last migration.
  int since_gain_ = 0;
  // Who stays in a migration.
  std::size_t kept_ = 0;
  int generation_ = 0;
  bool ends_generation_ = false;
  MethodState state_;
};

}  // namespace fourpost
