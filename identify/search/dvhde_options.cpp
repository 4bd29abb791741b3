#include "identify/search/dvhde_options.h"

#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

void RequireShare(std::string_view field, double value) {
  RequireOption(value >= 0 && value <= 1, field, value, "in [0, 1]");
}

}  // namespace

void DvhdeOptions::Validate() const {
  RequireOption(population >= 4, "population", population, "4 or more");
  RequireOption(draws_per_member >= 1, "draws_per_member", draws_per_member, "1 or more");
  RequireOption(best_share > 0 && best_share <= 1, "best_share", best_share, "in (0, 1]");
  RequireOption(factor > 0 && factor <= 2, "factor", factor, "in (0, 2]");
  RequireOption(factor_spread >= 0 && factor_spread <= factor, "factor_spread", factor_spread, "in [0, factor]");
  RequireShare("crossover", crossover);
  RequireOption(elites == 0 || elites >= 4, "elites", elites, "0 or 4 or more");
  RequireShare("elite_chance", elite_chance);
  RequireOption(elite_factor > 0 && elite_factor <= 2, "elite_factor", elite_factor, "in (0, 2]");
  RequireShare("accelerate_below", accelerate_below);
  RequireOption(simplex_iterations >= 0, "simplex_iterations", simplex_iterations, "0 or more");
  RequireOption(line_searches >= 0, "line_searches", line_searches, "0 or more");
  RequireOption(kicks >= 0, "kicks", kicks, "0 or more");
  RequireOption(refinements >= 1, "refinements", refinements, "1 or more");
  RequireOption(refine_apart >= 0 && refine_apart < 1, "refine_apart", refine_apart, "in [0, 1)");
  RequireOption(refine_iterations >= 1, "refine_iterations", refine_iterations, "1 or more");
  RequireOption(random_starts >= 0, "random_starts", random_starts, "0 or more");
  RequireOption(evolution_share >= 0, "evolution_share", evolution_share, "0 or more");
  RequireOption(migrate_after >= 0, "migrate_after", migrate_after, "0 or more");
  RequireOption(least_gain >= 0 && least_gain < 1, "least_gain", least_gain, "in [0, 1)");
  RequireOption(growth >= 1, "growth", growth, "1 or more");
  RequireOption(most_members >= 4, "most_members", most_members, "4 or more");
  RequireShare("migrate_below_diversity", migrate_below_diversity);
  RequireOption(gene_difference > 0 && gene_difference < 1, "gene_difference", gene_difference, "in (0, 1)");
}

DvhdeOptions ThesisDvhde() {
  DvhdeOptions options;
  options.population = 20;
  options.draws_per_member = 1;
  options.base = MutationBase::kBest;
  options.factor_rule = MutationFactor::kConstant;
  options.factor = 0.7;
  options.crossover = 0.8;
  options.forced_gene = false;
  options.replaced_parents = false;
  options.rank_violations = false;
  options.elites = 0;
  options.acceleration = Acceleration::kSimplex;
  options.accelerate_below = 0.1;
  options.random_starts = 0;
  options.give_up = false;
  options.migrate_after = 150;
  options.count_new_trials = false;
  options.least_gain = 0;
  options.keep_best = true;
  options.growth = 1;
  options.migrate_below_diversity = 0.1;
  options.diversity_measure = DiversityMeasure::kIndex;
  return options;
}

DvhdeOptions PlainEvolution() {
  DvhdeOptions options = ThesisDvhde();
  options.simplex_iterations = 0;
  options.migrate_after = 0;
  options.migrate_below_diversity = 0;
  return options;
}

}  // namespace fourpost
