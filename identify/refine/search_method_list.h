#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "identify/refine/multi_start.h"
#include "identify/search/adaptive_evolution.h"
#include "identify/search/cmaes.h"
#include "identify/search/downhill_simplex.h"
#include "identify/search/dvhde.h"
#include "identify/search/run_search.h"

namespace fourpost {

using MethodOptions = std::variant<DvhdeOptions, AdaptiveOptions, CmaesOptions, SimplexOptions, MultiStartOptions>;

/// Presets that go by a name:
/// - dvhde: what measures best for the kind of problem. Where there are as many residuals as parameters and no
///   discrete ones, some dvHDE and then Levenberg-Marquardt from its best; else as direct
/// - direct: what measures best without derivatives: AdaptiveEvolution where some parameters are discrete and some
///   not, Cmaes where all are of one kind, DownhillSimplex from scouts up to four continuous ones
/// - thesis: ThesisDvhde()
/// - de: PlainEvolution()
/// - ds: a downhill simplex from one random point
/// - gb: Levenberg-Marquardt (Ceres) from one random point; BFGS where there are fewer residuals than parameters
/// - bfgs: BFGS from one random point
/// - multistart: gb from random points until a rule ends it
/// - adaptive, cma: AdaptiveEvolution, Cmaes
inline constexpr std::array<std::string_view, 11> kMethodNames = {"auto", "dvhde", "direct",     "thesis",   "de", "ds",
                                                                  "gb",   "bfgs",  "multistart", "adaptive", "cma"};

/// Settings of a preset for a problem. Throws std::invalid_argument for a name that is not in kMethodNames.
MethodOptions MethodPreset(std::string_view name, const Problem& problem);

/// Every setting with its value, in the words of a study: ("population", "40"), ...
std::vector<std::pair<std::string, std::string>> Settings(const MethodOptions& options);

/// Throws std::invalid_argument naming the field, its value and its bound.
void Validate(const MethodOptions& options);

/// Runs a method on an archive until a rule ends it.
SearchResult RunMethod(const MethodOptions& options, Archive& archive, std::uint64_t seed, const StopRules& rules,
                       const CandidateRules& candidates, const SearchHooks& hooks = {});

}  // namespace fourpost
