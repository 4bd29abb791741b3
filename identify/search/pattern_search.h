#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "identify/search/draws.h"
#include "identify/search/lattice.h"
#include "identify/search/population.h"

namespace fourpost {

/// Moves one gene after the other of a point, each as long as that helps. Asks for one score at a time.
class PatternSearch {
 public:
  /// Tries a step one way and, unless it helped, the other way; goes on as long as steps help, each `growth` times the
  /// one before.
  struct Walk {
    std::size_t axis = 0;
    /// In indices; at least one is gone.
    double step = 1;
    double growth = 1;
  };

  /// From a point that has a score. The lattice must outlive it.
  PatternSearch(const Lattice& lattice, Individual from, std::vector<Walk> walks);
  /// From a point without a score, which is asked for first.
  PatternSearch(const Lattice& lattice, LatticePoint from, std::vector<Walk> walks);

  /// The point to score next; nothing at the end.
  const std::optional<LatticePoint>& Ask() const { return asked_; }
  void Tell(const Score& score);

  /// Where it has got to; needs the first score.
  const Individual& best() const { return at_; }
  /// Of walks that have ended: whether any of their steps helped; and the step that was tried last.
  struct Ended {
    bool helped = false;
    double step = 0;
  };
  const std::vector<Ended>& ended() const { return ended_; }

 private:
  void Begin();
  void Next();
  /// Asks for the next point of the walk; false where it leads nowhere.
  bool AskStep();
  void EndWalk();

  const Lattice* lattice_;
  Individual at_;
  bool has_score_ = true;
  std::deque<Walk> walks_;
  std::optional<LatticePoint> asked_;
  // Of the present walk.
  double step_ = 0;
  int direction_ = 1;
  bool helped_ = false;
  std::vector<Ended> ended_;
};

}  // namespace fourpost
