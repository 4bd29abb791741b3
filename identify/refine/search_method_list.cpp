#include "identify/refine/search_method_list.h"

#include <algorithm>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <type_traits>

#include "identify/refine/method_settings.h"
#include "identify/refine/refine.h"

namespace fourpost {
namespace {

bool IsLeastSquares(const Problem& problem) {
  return problem.residual_count >= static_cast<Eigen::Index>(problem.lattice.size());
}

std::size_t DiscreteCount(const Lattice& lattice) {
  return static_cast<std::size_t>(std::count_if(lattice.axes().begin(), lattice.axes().end(),
                                                [](const LatticeAxis& axis) { return axis.discrete; }));
}

MethodOptions Direct(const Lattice& lattice) {
  const std::size_t discrete = DiscreteCount(lattice);
  if (discrete > 0 && discrete < lattice.size()) return AdaptiveOptions{};
  if (discrete > 0) return CmaesOptions{.population = 30, .deviation = 0.5, .restart_after = 30};
  if (lattice.size() <= 4) return SimplexOptions{.scouts = 20, .from_scouts = true, .restarts = true};
  return CmaesOptions{.deviation = 0.2, .learning = 2, .scouts = 20};
}

MultiStartOptions Gradient(const Problem& problem) {
  MultiStartOptions options;
  if (!IsLeastSquares(problem)) options.descent = Descent::kQuasiNewton;
  return options;
}

/// Population and patience where a generation is little beside a refinement.
DvhdeOptions HybridEvolution(const Problem& problem) {
  DvhdeOptions options;
  if (!IsLeastSquares(problem) || DiscreteCount(problem.lattice) > 0) return options;
  options.acceleration = Acceleration::kLeastSquares;
  options.population = 10;
  options.migrate_after = 3;
  return options;
}

MethodOptions Default(const Problem& problem) {
  if (!IsLeastSquares(problem) || DiscreteCount(problem.lattice) > 0) return Direct(problem.lattice);
  MultiStartOptions options;
  options.explore_evaluations = 20;
  return options;
}

template <typename Options>
constexpr bool kIsLattice = !std::is_same_v<Options, MultiStartOptions>;

std::unique_ptr<SearchMethod> Make(const DvhdeOptions& options, const Lattice& lattice, std::uint64_t seed) {
  return std::make_unique<Dvhde>(lattice, options, seed);
}
std::unique_ptr<SearchMethod> Make(const AdaptiveOptions& options, const Lattice& lattice, std::uint64_t seed) {
  return std::make_unique<AdaptiveEvolution>(lattice, options, seed);
}
std::unique_ptr<SearchMethod> Make(const CmaesOptions& options, const Lattice& lattice, std::uint64_t seed) {
  return std::make_unique<Cmaes>(lattice, options, seed);
}
std::unique_ptr<SearchMethod> Make(const SimplexOptions& options, const Lattice& lattice, std::uint64_t seed) {
  return std::make_unique<DownhillSimplex>(lattice, options, seed);
}

/// Levenberg-Marquardt as dvHDE accelerates by it.
auto RefinementOf(Archive& archive, const DvhdeOptions& options) {
  return [&archive, most = options.refine_iterations, gives_up = options.give_up](const Eigen::VectorXd& values,
                                                                                  const std::function<bool()>& stop) {
    RefineOptions refine{.max_iterations = most, .step = 1e-5, .differences = Differences::kForward};
    if (gives_up && !archive.improvements().empty()) refine.give_up_above = archive.improvements().back().cost;
    const RefineResult result = Refine(archive, values, refine, stop);
    return result.has_cost() ? result.values : values;
  };
}

template <typename Value>
std::string Text(const Value& value) {
  std::ostringstream text;
  text << std::boolalpha << value;
  return text.str();
}

bool Accelerates(const DvhdeOptions& options) {
  switch (options.acceleration) {
    case Acceleration::kSimplex: return options.simplex_iterations > 0;
    case Acceleration::kPattern: return options.line_searches + options.kicks > 0;
    case Acceleration::kLeastSquares: return true;
  }
  return false;
}

std::string_view NameOf(const DvhdeOptions& options) {
  if (options == ThesisDvhde()) return "thesis";
  const bool migrates = options.migrate_after > 0 || options.migrate_below_diversity > 0;
  return Accelerates(options) || migrates ? "dvhde" : "de";
}
std::string_view NameOf(const AdaptiveOptions&) { return "adaptive"; }
std::string_view NameOf(const CmaesOptions&) { return "cmaes"; }
std::string_view NameOf(const SimplexOptions&) { return "simplex"; }
std::string_view NameOf(const MultiStartOptions& options) {
  if (options.starts != 1) return "multistart";
  return options.descent == Descent::kQuasiNewton ? "bfgs" : "gb";
}

}  // namespace

std::optional<std::string_view> PresentMethodName(std::string_view former) {
  if (former == "cma") return "cmaes";
  if (former == "ds") return "simplex";
  return std::nullopt;
}

std::string_view AlgorithmName(const MethodOptions& options) {
  return std::visit([](const auto& o) { return NameOf(o); }, options);
}

MethodOptions MethodPreset(std::string_view name, const Problem& problem) {
  if (name == "auto") return Default(problem);
  if (name == "dvhde") return HybridEvolution(problem);
  if (name == "direct") return Direct(problem.lattice);
  if (name == "thesis") return ThesisDvhde();
  if (name == "de") return PlainEvolution();
  if (name == "simplex") return SimplexOptions{};
  if (name == "adaptive") return AdaptiveOptions{};
  if (name == "cmaes") return CmaesOptions{};
  MultiStartOptions options = Gradient(problem);
  if (name == "multistart") return options;
  options.starts = 1;
  if (name == "gb") return options;
  options.descent = Descent::kQuasiNewton;
  if (name == "bfgs") return options;
  throw std::invalid_argument("there is no method '" + std::string(name) + "'");
}

std::vector<std::pair<std::string, std::string>> Settings(const MethodOptions& options) {
  std::vector<std::pair<std::string, std::string>> settings;
  const auto number = [&](const std::string& key, const auto& value) { settings.emplace_back(key, Text(value)); };
  const auto word = [&](const std::string& key, const auto& value, const auto& words) {
    settings.emplace_back(key, words.at(static_cast<std::size_t>(value)));
  };
  std::visit([&](const auto& o) { VisitSettings(o, number, word); }, options);
  return settings;
}

void Validate(const MethodOptions& options) {
  std::visit([](const auto& o) { o.Validate(); }, options);
}

SearchResult RunMethod(const MethodOptions& options, Archive& archive, std::uint64_t seed, const StopRules& rules,
                       const CandidateRules& candidates, const SearchHooks& hooks) {
  return std::visit(
      [&]<typename Options>(const Options& o) {
        if constexpr (!kIsLattice<Options>) {
          return RunMultiStart(archive, o, seed, rules, candidates, hooks);
        } else {
          const std::unique_ptr<SearchMethod> method = Make(o, archive.lattice(), seed);
          SearchHooks with_refine = hooks;
          if constexpr (std::is_same_v<Options, DvhdeOptions>)
            if (!hooks.refine) with_refine.refine = RefinementOf(archive, o);
          return RunSearch(archive, *method, rules, candidates, with_refine);
        }
      },
      options);
}

}  // namespace fourpost
