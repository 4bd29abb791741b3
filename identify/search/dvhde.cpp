#include "identify/search/dvhde.h"

#include <algorithm>
#include <utility>

#include "analysis/text/option_check.h"
#include "identify/search/dvhde_operators.h"

namespace fourpost {

void DvhdeOptions::Validate() const {
  RequireOption(population >= 4, "population", population, "4 or more");
  RequireOption(factor > 0 && factor <= 2, "factor", factor, "in (0, 2]");
  RequireOption(crossover >= 0 && crossover <= 1, "crossover", crossover, "in [0, 1]");
  RequireOption(simplex_iterations >= 0, "simplex_iterations", simplex_iterations, "0 or more");
  RequireOption(accelerate_below >= 0 && accelerate_below <= 1, "accelerate_below", accelerate_below, "in [0, 1]");
  RequireOption(migrate_after >= 0, "migrate_after", migrate_after, "0 or more");
  RequireOption(migrate_below_diversity >= 0 && migrate_below_diversity <= 1, "migrate_below_diversity",
                migrate_below_diversity, "in [0, 1]");
  RequireOption(gene_difference > 0 && gene_difference < 1, "gene_difference", gene_difference, "in (0, 1)");
}

DvhdeOptions ThesisDvhde() {
  DvhdeOptions options;
  options.population = 20;
  options.base = MutationBase::kBest;
  options.factor = 0.7;
  options.crossover = 0.8;
  options.forced_gene = false;
  options.rank_violations = false;
  options.migrate_after = 150;
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

Dvhde::Dvhde(const Lattice& lattice, const DvhdeOptions& options, std::uint64_t seed)
    : lattice_(&lattice), options_(options), seed_(seed) {
  options_.Validate();
  AskInitial();
}

const std::vector<LatticePoint>& Dvhde::Ask() const { return stage_ == Stage::kSimplex ? simplex_->Ask() : asked_; }

void Dvhde::Tell(const std::vector<Score>& told) {
  const std::vector<Score> scores = Ranked(told);
  ends_generation_ = false;
  switch (stage_) {
    case Stage::kInitial:
      for (std::size_t i = 0; i < scores.size(); ++i) population_.push_back({asked_[i], scores[i]});
      return EndGeneration();
    case Stage::kTrials: return Select(scores);
    case Stage::kSimplex: simplex_->Tell(scores); return Accelerate();
    case Stage::kMigrants: return Migrate(scores);
  }
}

void Dvhde::AskInitial() {
  for (std::size_t i = 0; i < static_cast<std::size_t>(options_.population); ++i) {
    Draws draws = DrawsFor(DrawPurpose::kInitial, i);
    asked_.push_back(RandomPoint(*lattice_, draws));
  }
}

void Dvhde::AskTrials() {
  stage_ = Stage::kTrials;
  ++generation_;
  previous_ = Best().score;
  const std::size_t best = BestIndex(population_);
  const double generation_factor = DrawsFor(DrawPurpose::kFactor, 0).Uniform();
  asked_.clear();
  for (std::size_t i = 0; i < population_.size(); ++i) {
    Draws draws = DrawsFor(DrawPurpose::kTrial, i);
    const auto [base, plus, minus] = PickThree(population_.size(), i, draws);
    const LatticePoint& start = Point(options_.base == MutationBase::kBest ? best : base);
    const LatticePoint mutant = Mutate(start, Point(plus), Point(minus), Factors(generation_factor, draws));
    asked_.push_back(Cross(Point(i), mutant, options_.crossover, options_.forced_gene, draws));
    Repair(*lattice_, asked_.back(), draws);
  }
}

void Dvhde::Select(const std::vector<Score>& scores) {
  state_.accelerated = false;
  state_.migrated = false;
  for (std::size_t i = 0; i < scores.size(); ++i) fourpost::Select(population_[i], {asked_[i], scores[i]});
  if (!IsSlow()) return EndEvolution();
  simplex_.emplace(*lattice_, population_);
  stage_ = Stage::kSimplex;
  state_.accelerated = true;
}

void Dvhde::Accelerate() {
  if (simplex_->iterations() >= options_.simplex_iterations || simplex_->IsCollapsed()) EndAcceleration();
}

void Dvhde::EndAcceleration() {
  // A copy of the best in place of the worst would only cost diversity.
  if (IsBetter(simplex_->best().score, Best().score)) population_[WorstIndex(population_)] = simplex_->best();
  EndEvolution();
}

void Dvhde::EndEvolution() {
  const bool gained = IsBetter(Best().score, previous_);
  state_.stagnant_generations = gained ? 0 : state_.stagnant_generations + 1;
  since_gain_ = gained ? 0 : since_gain_ + 1;
  if (NeedsMigration()) return AskMigrants();
  EndGeneration();
}

void Dvhde::AskMigrants() {
  stage_ = Stage::kMigrants;
  kept_ = BestIndex(population_);
  asked_.clear();
  for (std::size_t i = 0; i < population_.size(); ++i) {
    if (i == kept_) continue;
    Draws draws = DrawsFor(DrawPurpose::kMigration, i);
    asked_.push_back(Scatter(*lattice_, Point(kept_), draws));
  }
}

void Dvhde::Migrate(const std::vector<Score>& scores) {
  for (std::size_t i = 0; i < scores.size(); ++i) population_[i < kept_ ? i : i + 1] = {asked_[i], scores[i]};
  state_.migrated = true;
  since_gain_ = 0;
  EndGeneration();
}

void Dvhde::EndGeneration() {
  ends_generation_ = true;
  state_.generation = generation_;
  state_.diversity = CurrentDiversity();
  state_.collapsed = !CanMigrate() && IsCollapsed();
  AskTrials();
}

bool Dvhde::IsSlow() const {
  const Score now = Best().score;
  if (options_.simplex_iterations == 0 || !previous_.ok()) return false;
  return now.cost > (1 - options_.accelerate_below) * previous_.cost;
}

bool Dvhde::NeedsMigration() const {
  if (options_.migrate_after > 0 && since_gain_ >= options_.migrate_after) return true;
  return CurrentDiversity() < options_.migrate_below_diversity;
}

bool Dvhde::IsCollapsed() const {
  return std::all_of(population_.begin(), population_.end(),
                     [&](const Individual& member) { return member.point == Point(0); });
}

double Dvhde::CurrentDiversity() const {
  return Diversity(population_, *lattice_, options_.diversity_measure, options_.gene_difference);
}

std::vector<double> Dvhde::Factors(double generation_factor, Draws& draws) const {
  const bool constant = options_.factor_rule == MutationFactor::kConstant;
  std::vector<double> factors(lattice_->size(), constant ? options_.factor : generation_factor);
  if (options_.factor_rule == MutationFactor::kPerGene) {
    for (double& factor : factors) factor = draws.Uniform();
  }
  return factors;
}

Draws Dvhde::DrawsFor(DrawPurpose purpose, std::size_t individual) const {
  return Draws(seed_, purpose, generation_, individual);
}

std::vector<Score> Dvhde::Ranked(std::vector<Score> scores) const {
  if (!options_.rank_violations) {
    for (Score& score : scores) score.violation = 0;
  }
  return scores;
}

}  // namespace fourpost
