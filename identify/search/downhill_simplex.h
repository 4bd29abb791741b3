#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "identify/search/lattice_simplex.h"
#include "identify/search/search_method.h"

namespace fourpost {

/// Settings of DownhillSimplex.
struct SimplexOptions {
  /// Points drawn at random; the simplex starts from the best one, or with `from_scouts` from the best n + 1.
  int scouts = 1;
  bool from_scouts = false;
  /// Start anew elsewhere when the simplex has collapsed; else the search ends there.
  bool restarts = false;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

/// The downhill simplex (the thesis's DS) from random points; an iteration is a generation.
class DownhillSimplex : public SearchMethod {
 public:
  /// Equal seeds give equal searches. The lattice must outlive it.
  /// Throws std::invalid_argument for options out of bounds.
  DownhillSimplex(const Lattice& lattice, const SimplexOptions& options, std::uint64_t seed);

  const std::vector<LatticePoint>& Ask() const override;
  void Tell(const std::vector<Score>& scores) override;
  bool EndsGeneration() const override { return ends_generation_; }
  MethodState state() const override { return state_; }

 private:
  void AskScouts();
  void EndGeneration();

  const Lattice* lattice_;
  SimplexOptions options_;
  std::uint64_t seed_;
  std::vector<LatticePoint> asked_;
  std::optional<LatticeSimplex> simplex_;
  int iterations_ = 0;
  int restarts_ = 0;
  Score best_;
  bool ends_generation_ = false;
  MethodState state_;
};

}  // namespace fourpost
