#include "identify/dvhde.h"

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "analysis/option_check.h"
#include "identify/draws.h"
#include "identify/dvhde_operators.h"
#include "identify/lattice_simplex.h"

namespace fourpost {
namespace {

class Dvhde {
 public:
  Dvhde(Archive& archive, const DvhdeOptions& options, const SearchHooks& hooks)
      : archive_(archive), options_(options), hooks_(hooks), before_(archive.counts()) {}

  SearchResult Run() {
    Initialise();
    Log();
    while (!Ended()) {
      ++generation_.generation;
      const Score previous = Best().score;
      Evolve();
      if (IsSlow(previous)) Accelerate();
      CountStagnation(previous);
      if (IsStagnant() || IsUniform()) Migrate();
      Log();
    }
    result_.candidates = archive_.Best(options_.candidates, options_.candidate_separation);
    return result_;
  }

 private:
  void Initialise() {
    std::vector<LatticePoint> points;
    for (std::size_t i = 0; i < static_cast<std::size_t>(options_.population); ++i) {
      Draws draws = DrawsFor(DrawPurpose::kInitial, i);
      points.push_back(RandomPoint(lattice(), draws));
    }
    const std::vector<Score> scores = Evaluate(points);
    for (std::size_t i = 0; i < scores.size(); ++i) population_.push_back({points[i], scores[i]});
  }

  void Evolve() {
    const std::size_t best = BestIndex(population_);
    const double generation_factor = DrawsFor(DrawPurpose::kFactor, 0).Uniform();
    std::vector<LatticePoint> trials;
    for (std::size_t i = 0; i < population_.size(); ++i) {
      Draws draws = DrawsFor(DrawPurpose::kTrial, i);
      const auto [base, plus, minus] = PickThree(population_.size(), i, draws);
      const LatticePoint& start = Point(options_.base == MutationBase::kBest ? best : base);
      const LatticePoint mutant = Mutate(start, Point(plus), Point(minus), Factors(generation_factor, draws));
      trials.push_back(Cross(Point(i), mutant, options_.crossover, options_.forced_gene, draws));
      Repair(lattice(), trials.back(), draws);
    }
    const std::vector<Score> scores = Evaluate(trials);
    for (std::size_t i = 0; i < scores.size(); ++i) Select(population_[i], {trials[i], scores[i]});
  }

  void Accelerate() {
    if (interrupted_) return;
    const ScorePoints score = [this](const std::vector<LatticePoint>& points) { return Evaluate(points); };
    const Population simplex = StartSimplex(population_, lattice(), score);
    if (simplex.size() < 2) return;
    const Individual found = DownhillSimplex(simplex, lattice(), options_.simplex_iterations, score);
    generation_.accelerated = true;
    // A copy of the best in place of the worst would only cost diversity.
    if (IsBetter(found.score, Best().score)) population_[WorstIndex(population_)] = found;
  }

  void Migrate() {
    if (interrupted_) return;
    const std::size_t best = BestIndex(population_);
    std::vector<std::size_t> others;
    std::vector<LatticePoint> points;
    for (std::size_t i = 0; i < population_.size(); ++i) {
      if (i == best) continue;
      Draws draws = DrawsFor(DrawPurpose::kMigration, i);
      others.push_back(i);
      points.push_back(Scatter(lattice(), Point(best), draws));
    }
    const std::vector<Score> scores = Evaluate(points);
    for (std::size_t i = 0; i < scores.size(); ++i) population_[others[i]] = {points[i], scores[i]};
    generation_.migrated = true;
    stagnant_generations_ = 0;
  }

  bool IsSlow(const Score& previous) const {
    const Score now = Best().score;
    if (options_.simplex_iterations == 0 || !previous.ok()) return false;
    return now.cost > (1 - options_.accelerate_below) * previous.cost;
  }

  void CountStagnation(const Score& previous) {
    stagnant_generations_ = IsBetter(Best().score, previous) ? 0 : stagnant_generations_ + 1;
  }

  bool IsStagnant() const { return options_.migrate_after > 0 && stagnant_generations_ >= options_.migrate_after; }

  bool IsUniform() const { return CurrentDiversity() < options_.migrate_below_diversity; }

  // Answers fewer scores than asked when the budget is short or the search is stopped; that ends the search.
  std::vector<Score> Evaluate(std::vector<LatticePoint> points) {
    if (hooks_.stop && hooks_.stop()) interrupted_ = SearchEnd::kStopped;
    if (interrupted_) return {};
    const auto first_unpaid = FirstBeyondBudget(points);
    if (first_unpaid != points.end()) interrupted_ = SearchEnd::kEvaluations;
    points.erase(first_unpaid, points.end());
    return archive_.Evaluate(points);
  }

  std::vector<LatticePoint>::const_iterator FirstBeyondBudget(const std::vector<LatticePoint>& points) const {
    const std::int64_t left = options_.max_evaluations - Paid();
    std::set<LatticePoint> fresh;
    return std::find_if(points.begin(), points.end(), [&](const LatticePoint& point) {
      if (!archive_.Find(point)) fresh.insert(point);
      return static_cast<std::int64_t>(fresh.size()) > left;
    });
  }

  bool Ended() {
    const bool found = !population_.empty() && Best().score.ok();
    if (found && options_.target_cost && Best().score.cost <= *options_.target_cost) {
      result_.end = SearchEnd::kTarget;
    } else if (interrupted_) {
      result_.end = *interrupted_;
    } else if (Paid() >= options_.max_evaluations) {
      result_.end = SearchEnd::kEvaluations;
    } else if (generation_.generation >= options_.max_generations) {
      result_.end = SearchEnd::kGenerations;
    }
    return result_.end != SearchEnd::kNotRun;
  }

  void Log() {
    const EvaluationCounts& counts = archive_.counts();
    const bool found = !population_.empty() && Best().score.ok();
    generation_.best_cost = found ? Best().score.cost : std::numeric_limits<double>::infinity();
    generation_.paid = Paid();
    generation_.reused = counts.reused - before_.reused;
    generation_.failed = counts.failed() - before_.failed();
    generation_.diversity = CurrentDiversity();
    result_.log.push_back(generation_);
    if (hooks_.progress) hooks_.progress(generation_);
    generation_.accelerated = false;
    generation_.migrated = false;
  }

  std::vector<double> Factors(double generation_factor, Draws& draws) const {
    const bool constant = options_.factor_rule == MutationFactor::kConstant;
    std::vector<double> factors(lattice().size(), constant ? options_.factor : generation_factor);
    if (options_.factor_rule == MutationFactor::kPerGene) {
      for (double& factor : factors) factor = draws.Uniform();
    }
    return factors;
  }

  Draws DrawsFor(DrawPurpose purpose, std::size_t individual) const {
    return Draws(options_.seed, purpose, generation_.generation, individual);
  }

  double CurrentDiversity() const {
    if (population_.size() < 2) return 0;
    return Diversity(population_, lattice(), options_.diversity_measure, options_.gene_difference);
  }

  std::int64_t Paid() const { return archive_.counts().paid - before_.paid; }
  const Lattice& lattice() const { return archive_.lattice(); }
  const Individual& Best() const { return population_[BestIndex(population_)]; }
  const LatticePoint& Point(std::size_t i) const { return population_[i].point; }

  Archive& archive_;
  const DvhdeOptions& options_;
  const SearchHooks& hooks_;
  const EvaluationCounts before_;
  Population population_;
  SearchGeneration generation_;
  int stagnant_generations_ = 0;
  std::optional<SearchEnd> interrupted_;
  SearchResult result_;
};

}  // namespace

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
  RequireOption(max_evaluations >= 1, "max_evaluations", max_evaluations, "1 or more");
  RequireOption(max_generations >= 0, "max_generations", max_generations, "0 or more");
  RequireOption(!target_cost || *target_cost >= 0, "target_cost", target_cost.value_or(0), "0 or more");
  RequireOption(candidates >= 1, "candidates", candidates, "1 or more");
  RequireOption(candidate_separation >= 0 && candidate_separation < 1, "candidate_separation", candidate_separation,
                "in [0, 1)");
}

DvhdeOptions ThesisDvhde() {
  DvhdeOptions options;
  options.population = 20;
  options.base = MutationBase::kBest;
  options.factor = 0.7;
  options.crossover = 0.8;
  options.forced_gene = false;
  options.migrate_after = 150;
  options.migrate_below_diversity = 0.1;
  options.diversity_measure = DiversityMeasure::kIndex;
  options.max_generations = 150;
  return options;
}

std::string_view SearchEndName(SearchEnd end) {
  switch (end) {
    case SearchEnd::kNotRun: return "not run";
    case SearchEnd::kTarget: return "target cost reached";
    case SearchEnd::kEvaluations: return "evaluations used up";
    case SearchEnd::kGenerations: return "last generation reached";
    case SearchEnd::kStopped: return "stopped by the user";
  }
  return "unknown";
}

const Candidate& SearchResult::best() const {
  if (candidates.empty()) throw std::logic_error("the search found no point that could be evaluated");
  return candidates.front();
}

SearchResult SearchDvhde(Archive& archive, const DvhdeOptions& options, const SearchHooks& hooks) {
  options.Validate();
  return Dvhde(archive, options, hooks).Run();
}

}  // namespace fourpost
