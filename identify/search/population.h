#pragma once

#include <vector>

#include "identify/search/archive.h"
#include "identify/search/lattice.h"

namespace fourpost {

/// A member of a population.
struct Individual {
  LatticePoint point;
  Score score;
};

using Population = std::vector<Individual>;

/// The first of the best, and of the worst members. Need a member.
std::size_t BestIndex(const Population& population);
std::size_t WorstIndex(const Population& population);

/// How far a gene must be from the best one's to count as different.
enum class DiversityMeasure {
  /// |e - e_best| / (ne - 1): the same anywhere on the axis.
  kRange,
  /// |e - e_best| / e_best: thesis eq. 2.8 to the letter; biased where e_best is small.
  kIndex,
};

/// Share of the genes, over all members but the best, that differ from the best member's by more than `tolerance`
/// (thesis eq. 2.7-2.8): 0 = all alike, 1 = all different. Needs two members.
double Diversity(const Population& population, const Lattice& lattice, DiversityMeasure measure, double tolerance);

}  // namespace fourpost
