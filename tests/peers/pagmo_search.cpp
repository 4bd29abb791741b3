#include "tests/peers/pagmo_search.h"

#include <limits>
#include <utility>

#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <pagmo/types.hpp>

namespace fourpost {
namespace {

constexpr unsigned kGenerations = std::numeric_limits<unsigned>::max();
constexpr double kNoTolerance = 0;

// pagmo makes its problems before it copies into them, hence the default.
struct UnitCubeProblem {
  PeerObjective* objective = nullptr;

  pagmo::vector_double fitness(const pagmo::vector_double& unit) const { return {(*objective)(unit)}; }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    const std::size_t size = objective ? objective->size() : 1;
    return {pagmo::vector_double(size, 0), pagmo::vector_double(size, 1)};
  }
};

template <typename Algorithm>
void Minimise(const Algorithm& algorithm, PeerObjective& objective, const PeerSettings& settings, std::uint32_t seed) {
  const pagmo::population population(pagmo::problem(UnitCubeProblem{&objective}), CountOf(settings, "population"),
                                     seed);
  algorithm.evolve(population);
}

}  // namespace

void MinimiseByPagmoDe(PeerObjective& objective, const PeerSettings& settings, std::uint32_t seed) {
  const pagmo::de algorithm(kGenerations, ValueOf(settings, "factor"), ValueOf(settings, "crossover"),
                            CountOf(settings, "variant"), kNoTolerance, kNoTolerance, seed);
  Minimise(algorithm, objective, settings, seed);
}

void MinimiseByPagmoSade(PeerObjective& objective, const PeerSettings& settings, std::uint32_t seed) {
  const bool memory = false;
  const pagmo::sade algorithm(kGenerations, CountOf(settings, "variant"), CountOf(settings, "adaptation"), kNoTolerance,
                              kNoTolerance, memory, seed);
  Minimise(algorithm, objective, settings, seed);
}

void MinimiseByPagmoCmaes(PeerObjective& objective, const PeerSettings& settings, std::uint32_t seed) {
  const double usual = -1;
  const bool memory = false;
  const bool force_bounds = true;
  pagmo::cmaes algorithm(kGenerations, usual, usual, usual, usual, ValueOf(settings, "deviation"), kNoTolerance,
                         kNoTolerance, memory, force_bounds, seed);
  Minimise(algorithm, objective, settings, seed);
}

}  // namespace fourpost
