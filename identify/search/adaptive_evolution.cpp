#include "identify/search/adaptive_evolution.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "analysis/text/option_check.h"
#include "identify/search/dvhde_operators.h"

namespace fourpost {
namespace {

// Cauchy about the memory, as Tanabe and Fukunaga: drawn again below zero, cut off at one.
double DrawFactor(double about, Draws& draws) {
  double factor = 0;
  while (factor <= 0) factor = about + 0.1 * std::tan(std::numbers::pi * (draws.Uniform() - 0.5));
  return std::min(factor, 1.0);
}

double DrawCrossover(double about, Draws& draws) { return std::clamp(about + 0.1 * draws.Normal(), 0.0, 1.0); }

// Up or down at random, the nearer one more often: small differences between members do not vanish.
std::int64_t RoundAtRandom(double value, Draws& draws) {
  return static_cast<std::int64_t>(std::floor(value + draws.Uniform()));
}

}  // namespace

void AdaptiveOptions::Validate() const {
  RequireOption(population >= 4, "population", population, "4 or more");
  RequireOption(best_share > 0 && best_share <= 1, "best_share", best_share, "in (0, 1]");
  RequireOption(memory >= 1, "memory", memory, "1 or more");
  RequireOption(factor > 0 && factor <= 1, "factor", factor, "in (0, 1]");
  RequireOption(crossover >= 0 && crossover <= 1, "crossover", crossover, "in [0, 1]");
  RequireOption(line_searches >= 0, "line_searches", line_searches, "0 or more");
  RequireOption(restart_after >= 0, "restart_after", restart_after, "0 or more");
  RequireOption(least_gain >= 0 && least_gain < 1, "least_gain", least_gain, "in [0, 1)");
}

AdaptiveEvolution::AdaptiveEvolution(const Lattice& lattice, const AdaptiveOptions& options, std::uint64_t seed)
    : lattice_(&lattice), options_(options), seed_(seed) {
  options_.Validate();
  best_ever_.failure = Failure::kNotFinite;
  AskInitial();
}

void AdaptiveEvolution::Tell(const std::vector<Score>& scores) {
  ends_generation_ = false;
  switch (stage_) {
    case Stage::kInitial:
      for (std::size_t i = 0; i < scores.size(); ++i) population_.push_back({asked_[i], scores[i]});
      return EndGeneration();
    case Stage::kTrials: return Select(scores);
    case Stage::kLine: return TellLine(scores.front());
  }
}

void AdaptiveEvolution::AskInitial() {
  stage_ = Stage::kInitial;
  population_.clear();
  asked_.clear();
  for (std::size_t i = 0; i < static_cast<std::size_t>(options_.population); ++i) {
    Draws draws = DrawsFor(DrawPurpose::kInitial, i);
    asked_.push_back(RandomPoint(*lattice_, draws));
  }
  memory_.assign(static_cast<std::size_t>(options_.memory), {options_.factor, options_.crossover});
  memory_at_ = 0;
  steps_.clear();
  for (std::size_t j = 0; j < lattice_->size(); ++j)
    steps_.push_back(std::max<std::int64_t>(1, (lattice_->count(j) - 1) / 8));
  axis_ = 0;
  since_gain_ = 0;
  best_since_restart_ = {};
  best_since_restart_.failure = Failure::kNotFinite;
}

void AdaptiveEvolution::AskTrials() {
  stage_ = Stage::kTrials;
  std::vector<std::size_t> order(population_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return IsBetter(population_[a].score, population_[b].score); });
  asked_.clear();
  recipes_.assign(population_.size(), {});
  for (std::size_t i = 0; i < population_.size(); ++i) {
    Draws draws = DrawsFor(DrawPurpose::kTrial, i);
    asked_.push_back(Trial(i, order, recipes_[i], draws));
  }
}

// x + F (pbest - x) + F (a - b), binomially crossed with x.
LatticePoint AdaptiveEvolution::Trial(std::size_t i, const std::vector<std::size_t>& order, Recipe& recipe,
                                      Draws& draws) const {
  const Recipe& about = memory_[static_cast<std::size_t>(draws.Integer(0, options_.memory - 1))];
  recipe = {DrawFactor(about.factor, draws), DrawCrossover(about.crossover, draws)};
  const auto best_count =
      std::max<std::int64_t>(2, std::llround(options_.best_share * static_cast<double>(order.size())));
  const LatticePoint& best = population_[order[static_cast<std::size_t>(draws.Integer(0, best_count - 1))]].point;
  const auto [a, b, unused] = PickThree(population_.size(), i, draws);
  const LatticePoint& x = population_[i].point;
  LatticePoint mutant(x.size());
  for (std::size_t j = 0; j < x.size(); ++j) {
    const auto pull = static_cast<double>(best[j] - x[j] + population_[a].point[j] - population_[b].point[j]);
    mutant[j] = RoundAtRandom(static_cast<double>(x[j]) + recipe.factor * pull, draws);
  }
  LatticePoint trial = Cross(x, mutant, recipe.crossover, true, draws);
  Repair(*lattice_, trial, draws);
  return trial;
}

void AdaptiveEvolution::Select(const std::vector<Score>& scores) {
  std::vector<Recipe> successes;
  std::vector<double> gains;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    Individual& parent = population_[i];
    if (!IsBetter(scores[i], parent.score)) continue;
    successes.push_back(recipes_[i]);
    gains.push_back(scores[i].ok() && parent.score.ok() ? parent.score.cost - scores[i].cost : 0);
    parent = {asked_[i], scores[i]};
  }
  Learn(successes, gains);
  lines_left_ = options_.line_searches;
  if (lines_left_ > 0) return BeginLine();
  EndGeneration();
}

// Means weighted by what was gained; of factors the Lehmer mean, which favours the larger ones.
void AdaptiveEvolution::Learn(const std::vector<Recipe>& successes, const std::vector<double>& gains) {
  if (successes.empty()) return;
  const double total = std::accumulate(gains.begin(), gains.end(), 0.0);
  double squares = 0, factors = 0, crossovers = 0;
  for (std::size_t k = 0; k < successes.size(); ++k) {
    const double weight = total > 0 ? gains[k] / total : 1 / static_cast<double>(gains.size());
    squares += weight * successes[k].factor * successes[k].factor;
    factors += weight * successes[k].factor;
    crossovers += weight * successes[k].crossover;
  }
  memory_[memory_at_] = {squares / factors, crossovers};
  memory_at_ = (memory_at_ + 1) % memory_.size();
}

void AdaptiveEvolution::BeginLine() {
  stage_ = Stage::kLine;
  axis_ = (axis_ + 1) % lattice_->size();
  Draws draws = DrawsFor(DrawPurpose::kLine, axis_);
  direction_ = draws.Uniform() < 0.5 ? 1 : -1;
  turned_ = false;
  moved_ = false;
  AskLine();
}

void AdaptiveEvolution::AskLine() {
  LatticePoint point = population_[BestIndex(population_)].point;
  point[axis_] = std::clamp<std::int64_t>(point[axis_] + direction_ * steps_[axis_], 1, lattice_->count(axis_));
  asked_ = {point};
}

void AdaptiveEvolution::TellLine(const Score& score) {
  Individual& best = population_[BestIndex(population_)];
  std::int64_t& step = steps_[axis_];
  if (IsBetter(score, best.score)) {
    best = {asked_.front(), score};
    step = std::min(2 * step, std::max<std::int64_t>(1, (lattice_->count(axis_) - 1) / 2));
    moved_ = true;
    return AskLine();
  }
  if (!turned_ && !moved_) {
    turned_ = true;
    direction_ = -direction_;
    return AskLine();
  }
  step = std::max<std::int64_t>(1, step / 2);
  EndLine();
}

void AdaptiveEvolution::EndLine() {
  if (--lines_left_ > 0) return BeginLine();
  EndGeneration();
}

void AdaptiveEvolution::EndGeneration() {
  const Score& best = population_[BestIndex(population_)].score;
  ends_generation_ = true;
  state_.generation = generation_++;
  const bool both = best.ok() && best_since_restart_.ok();
  const bool gained =
      both ? best.cost < (1 - options_.least_gain) * best_since_restart_.cost : IsBetter(best, best_since_restart_);
  if (gained) best_since_restart_ = best;
  since_gain_ = gained ? 0 : since_gain_ + 1;
  const bool record = IsBetter(best, best_ever_);
  if (record) best_ever_ = best;
  state_.stagnant_generations = record ? 0 : state_.stagnant_generations + 1;
  state_.diversity = Diversity(population_, *lattice_, DiversityMeasure::kRange, 0.05);
  state_.migrated = options_.restart_after > 0 && since_gain_ >= options_.restart_after;
  if (state_.migrated) return AskInitial();
  AskTrials();
}

Draws AdaptiveEvolution::DrawsFor(DrawPurpose purpose, std::size_t individual) const {
  return Draws(seed_, purpose, generation_, individual);
}

}  // namespace fourpost
