#pragma once

#include "identify/search/population.h"

namespace fourpost {

/// What a mutant starts from: a random member (DE/rand/1/bin); the best one (DE/best/1/bin); or a random member moved
/// towards one of the best (rand-to-pbest/1/bin: r + F (b - r)).
enum class MutationBase { kRandom, kBest, kTowardsBest };

/// The mutation factor: a constant; one random number in [0, 1) for all of a generation; one for every gene of every
/// member (the thesis's random matrix); or one for each trial, uniform in factor +- factor_spread.
enum class MutationFactor { kConstant, kPerGeneration, kPerGene, kPerTrial };

/// What accelerates: iterations of a downhill simplex from the best members; pattern search from the best one, line by
/// line, and by kicks of a discrete gene that the other genes follow (extended polling, after Audet and Dennis, SIAM J.
/// Optim. 11, 2000), continuous ones by a simplex; or, for problems with residuals, Levenberg-Marquardt from good
/// members that are far from each other and from where it has been (the first hybrid DE used gradients as well: Chiou
/// and Wang, IEE Proc. Gener. Transm. Distrib. 146, 1999).
enum class Acceleration { kSimplex, kPattern, kLeastSquares };

/// Settings of dvHDE. The defaults are its own; ThesisDvhde() turns off what the thesis does not have.
struct DvhdeOptions {
  int population = 20;
  /// Random points drawn for each member of the first population and of a migration; the best are kept.
  int draws_per_member = 2;

  MutationBase base = MutationBase::kTowardsBest;
  /// For MutationBase::kTowardsBest: which share of the population counts as best; in (0, 1].
  double best_share = 0.3;
  MutationFactor factor_rule = MutationFactor::kPerTrial;
  /// For MutationFactor::kConstant and kPerTrial; in (0, 2].
  double factor = 0.5;
  double factor_spread = 0.2;
  /// Probability of a gene from the mutant; in [0, 1].
  double crossover = 0.95;
  /// At least one gene comes from the mutant.
  bool forced_gene = true;
  /// A difference may reach back to one of the parents that were replaced last, as many as members.
  bool replaced_parents = true;
  /// Rank infeasible points by their violation where the problem reports it; else all of them are alike.
  bool rank_violations = true;

  /// Points of the archive, the best since the last migration, that trials are made of when the search stagnates; 0
  /// turns it off. Their chance grows to `elite_chance` over two stagnant generations.
  int elites = 45;
  double elite_chance = 0.75;
  /// Uniform in elite_factor +- factor_spread.
  double elite_factor = 0.4;

  Acceleration acceleration = Acceleration::kPattern;
  /// Accelerate when the best cost fell by no more than this share since the last generation; in [0, 1].
  double accelerate_below = 1;
  /// Downhill-simplex iterations of an acceleration; with line_searches and kicks 0, none at all.
  int simplex_iterations = 5;
  /// Searches from the best member along axes that are not discrete, in turn.
  int line_searches = 3;
  /// Local searches from good members: on mixed lattices a step of a discrete gene that the others follow; with two to
  /// four continuous genes a downhill simplex of these, after such a step or without one.
  int kicks = 3;
  /// Members that Levenberg-Marquardt starts from in an acceleration, how far apart they are at least as a share of the
  /// range of some axis, and its most iterations. A migration follows, since nothing is left to gain near by.
  int refinements = 1;
  double refine_apart = 0.05;
  int refine_iterations = 100;
  /// Random points that it starts from after these. Where low costs are far from the best optimum, members alone lead
  /// to others again and again.
  int random_starts = 1;
  /// Give up a descent that heads for a cost above the best known, see RefineOptions::give_up_above.
  bool give_up = true;
  /// New trials before the next such acceleration, as a share of the evaluations of the last one.
  double evolution_share = 0.25;

  /// Migrate after so many stagnant generations; 0 turns it off. Below about 100 the thesis's rule breaks off searches
  /// that still make progress on problems with many minima.
  double migrate_after = 25;
  /// Stagnation counts evaluations: a generation counts as the share of its trials that is new, and a fiftieth.
  bool count_new_trials = true;
  /// Share by which the best cost must fall to end stagnation.
  double least_gain = 1e-4;
  /// The best member stays in the population after a migration, else in the archive alone.
  bool keep_best = false;
  /// Members after a migration over those before, up to `most_members` or those of the beginning if these are more.
  double growth = 1.3;
  int most_members = 100;
  /// Migrate when the diversity is below; in [0, 1], 0 turns it off. It keeps the population from settling anywhere
  /// finer than `gene_difference`, so it is off unless asked for.
  double migrate_below_diversity = 0;
  DiversityMeasure diversity_measure = DiversityMeasure::kRange;
  /// A gene counts as different when it is this far from the best one's; in (0, 1).
  double gene_difference = 0.05;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;

  bool operator==(const DvhdeOptions&) const = default;
};

/// dvHDE as the thesis has it for the Land Rover (ch. 5): 20 members, factor 0.7, crossover 0.8, migration below a
/// diversity of 0.1, acceleration below 10 %. Where the text is silent or in two minds, this is how it is read; "tried"
/// says that the other readings were compared with the thesis's own success rates, to which the choice is then fitted:
/// - Base: not stated for ch. 5; the best member. Tried: the gear train's rates only come with a random base, the coil
///   spring's only with the best, the other continuous problems suggest the best.
/// - Crossover: "parent if rand > mu_c" with a remark of fifty-fifty. mu_c is the probability of the mutant's gene
///   (tried: the other way round the gear train is solved a third as often); the remark contradicts mu_c = 0.8.
/// - A gene forced from the mutant: not mentioned, so none. Tried: of four published rates two fit with it, two
///   without.
/// - Illegal genes: replaced by random legal ones, as written. Tried: clipping solves the gear train a fourth as often.
/// - Members that make a mutant: differ from each other and from the parent; selection needs a strictly lower cost.
///   Tried: immaterial.
/// - Constraints: a point that violates one has no cost at all (death penalty); nothing else is mentioned.
/// - Acceleration: 5 iterations of the downhill simplex, started from the best members, one more than parameters; not
///   stated. Its result takes the place of the worst member if it is better than the best: otherwise it is a copy.
/// - Migration: replaces every member except the best. Tried: competing one-to-one loses what the thesis gains by it.
/// - Diversity (eq. 2.8): relative to the index of the best one's gene, to the letter, though biased where that is
///   small; DiversityMeasure::kRange is the alternative.
/// - Stagnation: 150 generations without a better cost, the gear train's. Tried: below 100 the rates collapse.
DvhdeOptions ThesisDvhde();

/// Plain differential evolution: ThesisDvhde() without acceleration and migration.
DvhdeOptions PlainEvolution();

}  // namespace fourpost
