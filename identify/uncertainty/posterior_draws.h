#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "identify/uncertainty/posterior.h"

namespace fourpost {

struct PosteriorDrawOptions {
  std::size_t count = 200;
  std::uint64_t seed = 1;
  /// The centre of each normal draw lies anywhere between an optimum and what is so far from it; empty: at the optimum.
  Eigen::VectorXd moved = {};
  /// Of the cost, at most, where it shapes the draws.
  std::int64_t max_evaluations = 20000;
  /// True ends the draws by BatchStopped.
  std::function<bool()> stop = {};
};

enum class DrawMethod { kNormal, kWeighted, kEnsemble };

struct PosteriorDraws {
  DrawMethod method = DrawMethod::kNormal;
  std::vector<Eigen::VectorXd> points;
  /// As many draws of the density itself as the weighted ones are worth; NaN without weights.
  double effective = std::numeric_limits<double>::quiet_NaN();
  /// Of an ensemble: generations, share of moves that were accepted, and the largest correlation over its members of
  /// where they were half-way with where they are, which is near 0 of one that has forgotten.
  int generations = 0;
  double accepted = 0;
  double remembered = 0;
};

/// Weighted draws that are worth less than this share of their number show that the density is not normal.
inline constexpr double kLeastEffectiveShare = 0.2;
/// An ensemble that remembers more has not got far from the normal draws that it began with.
inline constexpr double kMostRemembered = 0.5;

/// One per point; NaN where it cannot be evaluated.
using CostsOf = std::function<std::vector<double>(const std::vector<Eigen::VectorXd>& points)>;

/// Of the normal distributions about the optima, within the bounds.
PosteriorDraws DrawNormals(const Posterior& posterior, const PosteriorDrawOptions& options);

/// Of the density that the cost shapes: normal draws weighted by it and drawn again by their weights (Rubin 1988).
/// Where these are worth too few (Kish 1965), an ensemble of them moves by affine invariant stretches (Goodman and
/// Weare, Commun. Appl. Math. Comput. Sci. 5, 2010) until it has forgotten its start, or evaluations are used up. The
/// same for any number of threads that evaluate.
PosteriorDraws DrawByCost(const Posterior& posterior, const CostsOf& costs_of, const PosteriorDrawOptions& options);

}  // namespace fourpost
