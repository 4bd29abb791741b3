#pragma once

#include <functional>
#include <vector>

#include "identify/lattice.h"
#include "identify/population.h"

namespace fourpost {

/// Scores points, in order; answers fewer than asked when the search has to end.
using ScorePoints = std::function<std::vector<Score>(const std::vector<LatticePoint>& points)>;

/// Vertices for a search around the best of a population: its best members, as many as there are parameters plus one
/// and none of them twice, missing ones made from the best by a twentieth of the range along one axis each.
/// Fewer when `score` answers fewer.
Population StartSimplex(const Population& population, const Lattice& lattice, const ScorePoints& score);

/// Up to `iterations` of the downhill simplex of Nelder and Mead (Computer Journal 7, 1965; reflection 1, expansion 2,
/// contraction and shrinkage 1/2), each vertex rounded to the lattice and kept inside its bounds.
/// Returns the best vertex. Needs a simplex of two or more.
Individual DownhillSimplex(Population simplex, const Lattice& lattice, int iterations, const ScorePoints& score);

}  // namespace fourpost
