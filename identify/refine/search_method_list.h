#pragma once

#include <array>
#include <cstdint>
#include <optional>
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
/// - dvhde: DvhdeOptions as they are; where there are as many residuals as parameters and no discrete ones, its
///   acceleration is Levenberg-Marquardt
/// - thesis: ThesisDvhde()
/// - de: PlainEvolution()
/// - adaptive, cmaes: AdaptiveEvolution, Cmaes
/// - simplex: a downhill simplex from one random point
/// - gb: Levenberg-Marquardt (Ceres) from one random point; BFGS where there are fewer residuals than parameters
/// - bfgs: BFGS from one random point
/// - multistart: gb from random points until a rule ends it
/// - direct: chooses what measures best without derivatives: AdaptiveEvolution where some parameters are discrete and
///   some not, Cmaes where all are of one kind, DownhillSimplex from scouts up to four continuous ones
/// - auto: chooses; where there are as many residuals as parameters and no discrete ones, plain evolution and then
///   Levenberg-Marquardt from its best, else as direct
inline constexpr std::array<std::string_view, 11> kMethodNames = {
    "dvhde", "thesis", "de", "adaptive", "cmaes", "simplex", "gb", "bfgs", "multistart", "direct", "auto"};

/// The present name of a method that went by this one before version 0.2; nothing for any other.
std::optional<std::string_view> PresentMethodName(std::string_view former);

/// The algorithm that runs with these options, whatever chose it, by its name in kMethodNames: `thesis` to the letter
/// alone, `de` only without acceleration and migration.
std::string_view AlgorithmName(const MethodOptions& options);

/// Settings of a preset for a problem. Throws std::invalid_argument for a name that is not in kMethodNames.
MethodOptions MethodPreset(std::string_view name, const Problem& problem);

/// Every setting with its value, in the words of a study: ("population", "40"), ...
std::vector<std::pair<std::string, std::string>> Settings(const MethodOptions& options);

/// Throws std::invalid_argument naming the field, its value and its bound.
void Validate(const MethodOptions& options);

/// Runs a method on an archive until a rule ends it. dvHDE accelerates by `hooks.refine` or, without one, by
/// Levenberg-Marquardt with forward differences.
SearchResult RunMethod(const MethodOptions& options, Archive& archive, std::uint64_t seed, const StopRules& rules,
                       const CandidateRules& candidates, const SearchHooks& hooks = {});

}  // namespace fourpost
