#pragma once

#include <cstdint>
#include <vector>

#include "identify/search/draws.h"
#include "identify/search/population.h"
#include "identify/search/search_method.h"

namespace fourpost {

/// Settings of AdaptiveEvolution.
struct AdaptiveOptions {
  int population = 16;
  /// Trials are drawn towards one of this share of best members; in (0, 1].
  double best_share = 0.2;
  /// Length of the memory of successful factors and crossovers, and what it begins with; in (0, 1].
  int memory = 5;
  double factor = 0.5;
  double crossover = 0.9;
  /// Axes tried by the line search after each generation; 0 turns it off.
  int line_searches = 3;
  /// Start anew, the best one forgotten, after this many generations without a better cost; 0 turns it off.
  int restart_after = 15;
  /// Share of the cost that a better one must gain to count for that; in [0, 1).
  double least_gain = 1e-4;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

/// Differential evolution on lattice indices that learns its factor and crossover from what succeeds
/// (current-to-pbest/1/bin with success-history adaptation: Tanabe and Fukunaga, CEC 2013), with genes rounded at
/// random in proportion to how near they are, and a line search from the best member along one axis at a time: steps
/// double while the cost falls and halve when neither direction helps. Restarts with a new population.
class AdaptiveEvolution : public SearchMethod {
 public:
  /// Equal seeds give equal searches. The lattice must outlive it.
  /// Throws std::invalid_argument for options out of bounds.
  AdaptiveEvolution(const Lattice& lattice, const AdaptiveOptions& options, std::uint64_t seed);

  const std::vector<LatticePoint>& Ask() const override { return asked_; }
  void Tell(const std::vector<Score>& scores) override;
  bool EndsGeneration() const override { return ends_generation_; }
  MethodState state() const override {
    MethodState state = state_;
    state.step = stage_ == Stage::kLine ? SearchStep::kAccelerate : SearchStep::kEvolve;
    return state;
  }

 private:
  enum class Stage { kInitial, kTrials, kLine };

  // What a trial was made with.
  struct Recipe {
    double factor = 0;
    double crossover = 0;
  };

  void AskInitial();
  void AskTrials();
  LatticePoint Trial(std::size_t i, const std::vector<std::size_t>& order, Recipe& recipe, Draws& draws) const;
  void Select(const std::vector<Score>& scores);
  void Learn(const std::vector<Recipe>& successes, const std::vector<double>& gains);
  void BeginLine();
  void AskLine();
  void TellLine(const Score& score);
  void EndLine();
  void EndGeneration();
  Draws DrawsFor(DrawPurpose purpose, std::size_t individual) const;

  const Lattice* lattice_;
  AdaptiveOptions options_;
  std::uint64_t seed_;
  Stage stage_ = Stage::kInitial;
  Population population_;
  std::vector<LatticePoint> asked_;
  std::vector<Recipe> recipes_;
  std::vector<Recipe> memory_;
  std::size_t memory_at_ = 0;
  // The line search: axis, signed step, steps of all axes, whether the other direction was tried.
  std::size_t axis_ = 0;
  int lines_left_ = 0;
  std::int64_t direction_ = 1;
  std::vector<std::int64_t> steps_;
  bool turned_ = false;
  bool moved_ = false;
  Score best_ever_;
  Score best_since_restart_;
  int since_gain_ = 0;
  int generation_ = 0;
  bool ends_generation_ = false;
  MethodState state_;
};

}  // namespace fourpost
