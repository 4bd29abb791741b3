#pragma once

#include <vector>

#include "identify/search/lattice.h"
#include "identify/search/population.h"

namespace fourpost {

/// The downhill simplex of Nelder and Mead (Computer Journal 7, 1965; reflection 1, expansion 2, contraction and
/// shrinkage 1/2), each vertex rounded to the lattice and kept inside its bounds. Asks for scores and takes them.
class LatticeSimplex {
 public:
  /// Starts with the best members, as many as there are parameters plus one and none of them twice; missing ones are
  /// made from the best by a twentieth of the range along one axis each. Needs a member; the lattice must outlive it.
  LatticeSimplex(const Lattice& lattice, Population members);

  /// From one point, in the space of these axes: the other vertices are made by this share of the range along each.
  LatticeSimplex(const Lattice& lattice, Individual from, const std::vector<std::size_t>& axes, double share);

  /// Points to score next; never none.
  const std::vector<LatticePoint>& Ask() const { return asked_; }
  /// Scores of all of them, in their order.
  void Tell(const std::vector<Score>& scores);

  /// Completed ones.
  int iterations() const { return iterations_; }
  /// All vertices within one step of the lattice from the best: it cannot move any more.
  bool IsCollapsed() const;
  const Individual& best() const { return vertices_.front(); }
  /// Best first.
  const Population& vertices() const { return vertices_; }

 private:
  enum class Stage { kVertices, kReflection, kExpansion, kContraction, kShrinkage };

  void Reflected(const Individual& reflected);
  void Contract(bool outside);
  void Shrink();
  void ReplaceWorst(const Individual& vertex);
  void Iterate();
  void AskThrough(double share, Stage stage);
  // worst + share (centroid of the others - worst).
  LatticePoint Through(double share) const;

  const Lattice* lattice_;
  Population vertices_;
  Stage stage_ = Stage::kVertices;
  std::vector<LatticePoint> asked_;
  Individual reflected_;
  // What a contraction has to beat.
  Score limit_;
  int iterations_ = 0;
};

}  // namespace fourpost
