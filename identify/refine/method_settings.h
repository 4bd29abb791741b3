#pragma once

#include <array>
#include <string>
#include <string_view>
#include <type_traits>

#include "identify/refine/search_method_list.h"

namespace fourpost {

/// Words for the values of a setting, in the order of its enumeration.
inline constexpr std::array<std::string_view, 3> kMutationBaseWords = {"random", "best", "towards_best"};
inline constexpr std::array<std::string_view, 4> kMutationFactorWords = {"constant", "per_generation", "per_gene",
                                                                         "per_trial"};
inline constexpr std::array<std::string_view, 3> kAccelerationWords = {"simplex", "pattern", "least_squares"};
inline constexpr std::array<std::string_view, 2> kDiversityWords = {"range", "index"};
inline constexpr std::array<std::string_view, 2> kDescentWords = {"levenberg_marquardt", "quasi_newton"};
inline constexpr std::array<std::string_view, 2> kExplorerWords = {"evolution", "cmaes"};
inline constexpr std::array<std::string_view, 3> kDifferencesWords = {"central", "forward", "automatic"};

// VisitSettings calls number(key, field) for numbers and flags, word(key, field, words) for enumerations: one table of
// keys for reading and printing.

template <typename Options, typename Number, typename Word>
requires std::is_same_v<std::remove_const_t<Options>, DvhdeOptions>
void VisitSettings(Options& o, const Number& number, const Word& word) {
  number("population", o.population);
  number("draws_per_member", o.draws_per_member);
  word("base", o.base, kMutationBaseWords);
  number("best_share", o.best_share);
  word("factor_rule", o.factor_rule, kMutationFactorWords);
  number("factor", o.factor);
  number("factor_spread", o.factor_spread);
  number("crossover", o.crossover);
  number("forced_gene", o.forced_gene);
  number("replaced_parents", o.replaced_parents);
  number("rank_violations", o.rank_violations);
  number("elites", o.elites);
  number("elite_chance", o.elite_chance);
  number("elite_factor", o.elite_factor);
  word("acceleration", o.acceleration, kAccelerationWords);
  number("accelerate_below", o.accelerate_below);
  number("simplex_iterations", o.simplex_iterations);
  number("line_searches", o.line_searches);
  number("kicks", o.kicks);
  number("refinements", o.refinements);
  number("refine_apart", o.refine_apart);
  number("refine_iterations", o.refine_iterations);
  number("random_starts", o.random_starts);
  number("give_up", o.give_up);
  number("evolution_share", o.evolution_share);
  number("migrate_after", o.migrate_after);
  number("count_new_trials", o.count_new_trials);
  number("least_gain", o.least_gain);
  number("keep_best", o.keep_best);
  number("growth", o.growth);
  number("most_members", o.most_members);
  number("migrate_below_diversity", o.migrate_below_diversity);
  word("diversity_measure", o.diversity_measure, kDiversityWords);
  number("gene_difference", o.gene_difference);
}

template <typename Options, typename Number, typename Word>
requires std::is_same_v<std::remove_const_t<Options>, AdaptiveOptions>
void VisitSettings(Options& o, const Number& number, const Word&) {
  number("population", o.population);
  number("best_share", o.best_share);
  number("memory", o.memory);
  number("factor", o.factor);
  number("crossover", o.crossover);
  number("line_searches", o.line_searches);
  number("restart_after", o.restart_after);
  number("least_gain", o.least_gain);
}

template <typename Options, typename Number, typename Word>
requires std::is_same_v<std::remove_const_t<Options>, CmaesOptions>
void VisitSettings(Options& o, const Number& number, const Word&) {
  number("population", o.population);
  number("deviation", o.deviation);
  number("logarithmic", o.logarithmic);
  number("learning", o.learning);
  number("least_steps", o.least_steps);
  number("restart_after", o.restart_after);
  number("scouts", o.scouts);
}

template <typename Options, typename Number, typename Word>
requires std::is_same_v<std::remove_const_t<Options>, SimplexOptions>
void VisitSettings(Options& o, const Number& number, const Word&) {
  number("scouts", o.scouts);
  number("from_scouts", o.from_scouts);
  number("restarts", o.restarts);
}

template <typename Options, typename Number, typename Word>
requires std::is_same_v<std::remove_const_t<Options>, MultiStartOptions>
void VisitSettings(Options& o, const Number& number, const Word& word) {
  word("descent", o.descent, kDescentWords);
  word("differences", o.refine.differences, kDifferencesWords);
  number("step", o.refine.step);
  number("cost_tolerance", o.refine.cost_tolerance);
  number("step_tolerance", o.refine.step_tolerance);
  number("max_iterations", o.refine.max_iterations);
  number("scouts", o.scouts);
  number("starts", o.starts);
  number("starts_each", o.starts_each);
  number("explore_evaluations", o.explore_evaluations);
  word("explorer", o.explorer, kExplorerWords);
  // How evolution explores; without it these play no part.
  const auto prefixed = [&](const auto& visit) {
    return [&](const std::string& key, auto& field, const auto&... words) { visit("explore_" + key, field, words...); };
  };
  VisitSettings(o.explore, prefixed(number), prefixed(word));
}

}  // namespace fourpost
