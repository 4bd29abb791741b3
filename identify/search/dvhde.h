#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <vector>

#include "identify/search/archive.h"
#include "identify/search/draws.h"
#include "identify/search/dvhde_options.h"
#include "identify/search/elites.h"
#include "identify/search/lattice_simplex.h"
#include "identify/search/pattern_search.h"
#include "identify/search/population.h"
#include "identify/search/run_search.h"
#include "identify/search/search_method.h"

namespace fourpost {

/// Discrete-variable hybrid differential evolution (thesis ch. 2): differential evolution on lattice indices, with
/// acceleration (a downhill simplex, or pattern search) and migration. Beyond the thesis: rand-to-pbest mutants with
/// replaced parents, as in JADE (Zhang and Sanderson, IEEE Trans. Evol. Comput. 13, 2009), trials from the best points
/// of the archive, stagnation counted in new points, and a population that grows with each migration.
class Dvhde : public SearchMethod {
 public:
  /// Equal seeds give equal searches. The lattice must outlive it.
  /// Throws std::invalid_argument for options out of bounds.
  Dvhde(const Lattice& lattice, const DvhdeOptions& options, std::uint64_t seed);

  const std::vector<LatticePoint>& Ask() const override;
  void Tell(const std::vector<Score>& scores) override;
  const std::vector<LatticePoint>& AskRefined() const override { return refined_from_; }
  void TellRefined(const Population& found, std::int64_t evaluations) override;
  bool EndsGeneration() const override { return ends_generation_; }
  MethodState state() const override;

  const Population& population() const { return population_; }

 private:
  enum class Stage { kInitial, kTrials, kSimplex, kLines, kKicks, kFollowing, kRefinements, kMigrants };

  void AskInitial();
  void AskTrials();
  LatticePoint Trial(std::size_t parent, double generation_factor, Draws& draws) const;
  LatticePoint TrialTowardsBest(std::size_t parent, Draws& draws) const;
  LatticePoint TrialOfElites(Draws& draws) const;
  void AskMigrants();
  void Keep(const std::vector<Score>& scores);
  void Select(const std::vector<Score>& scores);
  void Accelerate();
  void AskLines();
  void EndLines();
  void AskKick();
  void EndKick();
  bool HasSimplex() const;
  void Follow(const Individual& from);
  void EndFollowing();
  void AskOne();
  void AskRefinements();
  void AskRandomRefinements();
  void EndSimplex();
  void Migrate(const std::vector<Score>& scores);
  void EndEvolution();
  void EndGeneration();

  bool Accelerates() const;
  bool IsSlow() const;
  bool NeedsMigration() const;
  bool IsCollapsed() const;
  bool CanMigrate() const { return options_.migrate_after > 0 || options_.migrate_below_diversity > 0; }
  double CurrentDiversity() const;
  std::vector<double> Factors(double generation_factor, Draws& draws) const;
  double TrialFactor(double factor, Draws& draws) const;
  Draws DrawsFor(DrawPurpose purpose, std::size_t individual) const;
  std::vector<Score> Ranked(std::vector<Score> scores) const;
  std::vector<std::size_t> BestFirst() const;
  std::size_t OneOfTheBest(Draws& draws) const;
  const Individual& Best() const { return population_[BestIndex(population_)]; }
  const LatticePoint& Point(std::size_t i) const { return population_[i].point; }

  const Lattice* lattice_;
  DvhdeOptions options_;
  std::uint64_t seed_;
  Stage stage_ = Stage::kInitial;
  Population population_;
  // Members that the next population has.
  std::size_t members_ = 0;
  std::vector<LatticePoint> asked_;
  std::optional<LatticeSimplex> simplex_;
  std::optional<PatternSearch> pattern_;
  std::vector<std::size_t> continuous_;
  std::vector<std::size_t> discrete_;
  // Steps of line searches, in indices, whose turn it is, and where they go now.
  std::vector<double> line_steps_;
  std::size_t line_turn_ = 0;
  std::vector<std::size_t> line_axes_;
  int kicks_done_ = 0;
  std::size_t kicked_ = 0;
  double simplex_share_ = 0;
  // Members that are being refined, and where all refinements began and ended.
  std::vector<LatticePoint> refined_from_;
  std::vector<std::size_t> refined_members_;
  std::vector<LatticePoint> refined_;
  // New trials since the last refinements, and how many there have to be before the next.
  double evolved_ = 0;
  double evolution_due_ = 0;
  Elites elites_;
  std::deque<LatticePoint> replaced_;
  std::set<LatticePoint> tried_;
  // Best of all.
  Individual record_;
  // The best before this generation.
  Score previous_;
  // What the best cost has to fall below to end stagnation.
  Score reference_;
  // Stagnant generations since the last gain or the last migration, see DvhdeOptions::count_new_trials.
  double stagnation_ = 0;
  double generation_weight_ = 1;
  // Who stays in a migration.
  std::optional<Individual> kept_;
  int generation_ = 0;
  bool ends_generation_ = false;
  MethodState state_;
};

}  // namespace fourpost
