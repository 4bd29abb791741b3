#include "identify/search/dvhde_operators.h"

#include <cmath>

namespace fourpost {

LatticePoint RandomPoint(const Lattice& lattice, Draws& draws) {
  LatticePoint point(lattice.size());
  for (std::size_t j = 0; j < point.size(); ++j) point[j] = draws.Integer(1, lattice.count(j));
  return point;
}

std::array<std::size_t, 3> PickThree(std::size_t population, std::size_t excluded, Draws& draws) {
  std::array<std::size_t, 4> taken = {excluded};
  const auto last = static_cast<std::int64_t>(population) - 1;
  for (std::size_t k = 1; k < taken.size(); ++k) {
    const auto is_taken = [&](std::size_t pick) {
      for (std::size_t i = 0; i < k; ++i) {
        if (taken[i] == pick) return true;
      }
      return false;
    };
    do {
      taken[k] = static_cast<std::size_t>(draws.Integer(0, last));
    } while (is_taken(taken[k]));
  }
  return {taken[1], taken[2], taken[3]};
}

LatticePoint Mutate(const LatticePoint& base, const LatticePoint& plus, const LatticePoint& minus,
                    const std::vector<double>& factors) {
  LatticePoint mutant(base.size());
  for (std::size_t j = 0; j < base.size(); ++j) {
    mutant[j] = base[j] + std::llround(factors[j] * static_cast<double>(plus[j] - minus[j]));
  }
  return mutant;
}

LatticePoint MutateTowards(const LatticePoint& start, const LatticePoint& towards, const LatticePoint& plus,
                           const LatticePoint& minus, double factor) {
  LatticePoint mutant(start.size());
  for (std::size_t j = 0; j < start.size(); ++j)
    mutant[j] = start[j] + std::llround(factor * static_cast<double>(towards[j] - start[j] + plus[j] - minus[j]));
  return mutant;
}

LatticePoint Cross(const LatticePoint& parent, const LatticePoint& mutant, double rate, bool forced_gene,
                   Draws& draws) {
  LatticePoint trial = parent;
  for (std::size_t j = 0; j < trial.size(); ++j) {
    if (draws.Uniform() < rate) trial[j] = mutant[j];
  }
  if (forced_gene) {
    const auto forced = static_cast<std::size_t>(draws.Integer(0, static_cast<std::int64_t>(trial.size()) - 1));
    trial[forced] = mutant[forced];
  }
  return trial;
}

void Repair(const Lattice& lattice, LatticePoint& point, Draws& draws) {
  for (std::size_t j = 0; j < point.size(); ++j) {
    if (point[j] < 1 || point[j] > lattice.count(j)) point[j] = draws.Integer(1, lattice.count(j));
  }
}

void Select(Individual& parent, const Individual& trial) {
  if (IsBetter(trial.score, parent.score)) parent = trial;
}

LatticePoint Scatter(const Lattice& lattice, const LatticePoint& best, Draws& draws) {
  LatticePoint point(best.size());
  for (std::size_t j = 0; j < best.size(); ++j) {
    const std::int64_t last = lattice.count(j);
    const double below = static_cast<double>(best[j] - 1) / static_cast<double>(last - 1);
    const std::int64_t end = draws.Uniform() < below ? 1 : last;
    point[j] = best[j] + std::llround(draws.Uniform() * static_cast<double>(end - best[j]));
  }
  return point;
}

}  // namespace fourpost
