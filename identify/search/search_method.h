#pragma once

#include <cstdint>
#include <vector>

#include "identify/search/archive.h"
#include "identify/search/lattice.h"
#include "identify/search/population.h"

namespace fourpost {

/// What points are asked for.
enum class SearchStep { kEvolve, kAccelerate, kMigrate };

/// Where a method has got to, for the log and for stopping rules.
struct MethodState {
  /// Of the points asked for now.
  SearchStep step = SearchStep::kEvolve;
  /// 0 is the initial population.
  int generation = 0;
  /// Generations in a row without a better best.
  int stagnant_generations = 0;
  /// Share of genes that differ from the best member's; 0 for methods without a population.
  double diversity = 0;
  /// All members on one point, from where the method alone finds nowhere else.
  bool collapsed = false;
  /// In this generation.
  bool accelerated = false;
  bool migrated = false;
};

/// A search over lattice points that asks for scores and takes them, so that whoever runs it decides when, where and
/// whether points are evaluated, and may stop between any two batches and go on later. All randomness comes from the
/// seed: the same scores lead to the same points.
class SearchMethod {
 public:
  virtual ~SearchMethod() = default;

  /// Points to score next; the same ones until their scores are there. None: the method has ended by itself.
  virtual const std::vector<LatticePoint>& Ask() const = 0;

  /// Scores of the points asked for, in their order.
  virtual void Tell(const std::vector<Score>& scores) = 0;

  /// Points to start refinements by derivatives from next, in place of points to score; most often none.
  virtual const std::vector<LatticePoint>& AskRefined() const {
    static const std::vector<LatticePoint> none;
    return none;
  }

  /// Where each of them has led, in their order, on the lattice, and how many evaluations all of that took.
  virtual void TellRefined(const Population&, std::int64_t) {}

  /// Whether the last scores completed a generation.
  virtual bool EndsGeneration() const = 0;

  virtual MethodState state() const = 0;
};

}  // namespace fourpost
