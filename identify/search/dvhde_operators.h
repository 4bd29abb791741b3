#pragma once

#include <array>
#include <vector>

#include "identify/search/draws.h"
#include "identify/search/lattice.h"
#include "identify/search/population.h"

namespace fourpost {

/// Each gene uniform over its axis.
LatticePoint RandomPoint(const Lattice& lattice, Draws& draws);

/// Three members, different from each other and from `excluded`. Needs a population of 4 or more.
std::array<std::size_t, 3> PickThree(std::size_t population, std::size_t excluded, Draws& draws);

/// base + round(factor (plus - minus)) for each gene (thesis eq. 2.2); may leave the lattice.
LatticePoint Mutate(const LatticePoint& base, const LatticePoint& plus, const LatticePoint& minus,
                    const std::vector<double>& factors);

/// start + round(factor (towards - start) + factor (plus - minus)): rand-to-pbest/1; may leave the lattice.
LatticePoint MutateTowards(const LatticePoint& start, const LatticePoint& towards, const LatticePoint& plus,
                           const LatticePoint& minus, double factor);

/// Binomial crossover (thesis eq. 2.3): a gene is the mutant's with probability `rate`, else the parent's. With
/// `forced_gene` one gene, drawn at random, is the mutant's in any case, so that no trial equals its parent.
LatticePoint Cross(const LatticePoint& parent, const LatticePoint& mutant, double rate, bool forced_gene, Draws& draws);

/// Replaces each gene off its axis by a random one on it; clipping would gather the population at the bounds.
void Repair(const Lattice& lattice, LatticePoint& point, Draws& draws);

/// One-to-one and greedy: the trial takes the parent's place when strictly better, so of two failures the parent stays.
void Select(Individual& parent, const Individual& trial);

/// A new member scattered around the best over the whole space (thesis eq. 2.6): each gene moves from the best one's by
/// a uniform share of the way to the first or to the last index, more often to the further one.
LatticePoint Scatter(const Lattice& lattice, const LatticePoint& best, Draws& draws);

}  // namespace fourpost
