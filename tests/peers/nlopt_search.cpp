#include "tests/peers/nlopt_search.h"

#include <algorithm>
#include <exception>
#include <vector>

#include <nlopt.hpp>

#include "identify/search/draws.h"

namespace fourpost {
namespace {

// What went through NLopt's C code; it must see its own exception only.
struct Call {
  PeerObjective& objective;
  std::exception_ptr thrown;
};

double Cost(const std::vector<double>& unit, std::vector<double>&, void* data) {
  Call& call = *static_cast<Call*>(data);
  try {
    return call.objective(unit);
  } catch (...) {
    call.thrown = std::current_exception();
  }
  throw nlopt::forced_stop();
}

std::vector<double> RandomPoint(std::size_t size, std::uint32_t seed) {
  Draws draws(seed, DrawPurpose::kStart, 0, 0);
  std::vector<double> unit(size);
  for (double& coordinate : unit) coordinate = draws.Uniform();
  return unit;
}

void Minimise(nlopt::algorithm algorithm, PeerObjective& objective, const PeerSettings& settings, std::uint32_t seed) {
  nlopt::srand(seed);
  nlopt::opt search(algorithm, static_cast<unsigned>(objective.size()));
  Call call = {objective, nullptr};
  search.set_min_objective(Cost, &call);
  search.set_lower_bounds(0.0);
  search.set_upper_bounds(1.0);
  const auto fewest = static_cast<unsigned>(objective.size()) + 1;
  search.set_population(std::max(CountOf(settings, "population"), fewest));
  std::vector<double> unit = RandomPoint(objective.size(), seed);
  double cost = 0;
  try {
    search.optimize(unit, cost);
  } catch (const nlopt::forced_stop&) {
    std::rethrow_exception(call.thrown);
  } catch (const nlopt::roundoff_limited&) {
    // Ends the start.
  }
}

}  // namespace

void MinimiseByNloptCrs2(PeerObjective& objective, const PeerSettings& settings, std::uint32_t seed) {
  Minimise(nlopt::GN_CRS2_LM, objective, settings, seed);
}

void MinimiseByNloptIsres(PeerObjective& objective, const PeerSettings& settings, std::uint32_t seed) {
  Minimise(nlopt::GN_ISRES, objective, settings, seed);
}

}  // namespace fourpost
