#include "identify/search/population.h"

#include <algorithm>
#include <cmath>

namespace fourpost {
namespace {

bool GeneDiffers(std::int64_t gene, std::int64_t best, std::int64_t count, DiversityMeasure measure, double tolerance) {
  const double difference = static_cast<double>(std::abs(gene - best));
  const double reference = static_cast<double>(measure == DiversityMeasure::kRange ? count - 1 : best);
  return difference > tolerance * reference;
}

}  // namespace

std::size_t BestIndex(const Population& population) {
  const auto better = [](const Individual& a, const Individual& b) { return IsBetter(a.score, b.score); };
  return static_cast<std::size_t>(std::min_element(population.begin(), population.end(), better) - population.begin());
}

std::size_t WorstIndex(const Population& population) {
  const auto worse = [](const Individual& a, const Individual& b) { return IsBetter(b.score, a.score); };
  return static_cast<std::size_t>(std::min_element(population.begin(), population.end(), worse) - population.begin());
}

double Diversity(const Population& population, const Lattice& lattice, DiversityMeasure measure, double tolerance) {
  const LatticePoint& best = population[BestIndex(population)].point;
  std::size_t different = 0;
  // The best one itself adds nothing.
  for (const Individual& member : population) {
    for (std::size_t j = 0; j < lattice.size(); ++j) {
      different += GeneDiffers(member.point[j], best[j], lattice.count(j), measure, tolerance);
    }
  }
  return static_cast<double>(different) / static_cast<double>(lattice.size() * (population.size() - 1));
}

}  // namespace fourpost
