#include "identify/search/dvhde.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "identify/search/dvhde_operators.h"

namespace fourpost {
namespace {

constexpr double kFirstLineStep = 0.25;  // of the range
// Of a simplex of continuous genes, for each axis.
constexpr int kSimplexIterations = 15;

std::vector<std::size_t> AxesOf(const Lattice& lattice, bool discrete) {
  std::vector<std::size_t> axes;
  for (std::size_t j = 0; j < lattice.size(); ++j)
    if (lattice.axes()[j].discrete == discrete) axes.push_back(j);
  return axes;
}

std::vector<double> FirstLineSteps(const Lattice& lattice) {
  std::vector<double> steps;
  for (std::size_t j = 0; j < lattice.size(); ++j)
    steps.push_back(kFirstLineStep * static_cast<double>(lattice.count(j) - 1));
  return steps;
}

template <typename List>
const auto& AnyOf(const List& list, Draws& draws) {
  return list[static_cast<std::size_t>(draws.Integer(0, static_cast<std::int64_t>(list.size()) - 1))];
}

}  // namespace

Dvhde::Dvhde(const Lattice& lattice, const DvhdeOptions& options, std::uint64_t seed)
    : lattice_(&lattice),
      options_(options),
      seed_(seed),
      members_(static_cast<std::size_t>(options.population)),
      continuous_(AxesOf(lattice, false)),
      discrete_(AxesOf(lattice, true)),
      line_steps_(FirstLineSteps(lattice)),
      elites_(static_cast<std::size_t>(options.elites)) {
  options_.Validate();
  AskInitial();
}

const std::vector<LatticePoint>& Dvhde::Ask() const {
  return stage_ == Stage::kSimplex || stage_ == Stage::kFollowing ? simplex_->Ask() : asked_;
}

void Dvhde::Tell(const std::vector<Score>& told) {
  const std::vector<Score> scores = Ranked(told);
  ends_generation_ = false;
  switch (stage_) {
    case Stage::kInitial:
      Keep(scores);
      return options_.acceleration == Acceleration::kLeastSquares ? Accelerate() : EndGeneration();
    case Stage::kTrials: return Select(scores);
    case Stage::kSimplex:
      simplex_->Tell(scores);
      if (simplex_->iterations() >= options_.simplex_iterations || simplex_->IsCollapsed()) EndSimplex();
      return;
    case Stage::kFollowing:
      simplex_->Tell(scores);
      if (simplex_->iterations() >= kSimplexIterations * static_cast<int>(continuous_.size()) ||
          simplex_->IsCollapsed())
        EndFollowing();
      return;
    case Stage::kLines: pattern_->Tell(scores.front()); return pattern_->Ask() ? AskOne() : EndLines();
    case Stage::kKicks: pattern_->Tell(scores.front()); return pattern_->Ask() ? AskOne() : EndKick();
    case Stage::kRefinements: return;
    case Stage::kMigrants: return Migrate(scores);
  }
}

MethodState Dvhde::state() const {
  MethodState state = state_;
  switch (stage_) {
    case Stage::kInitial:
    case Stage::kTrials: state.step = SearchStep::kEvolve; break;
    case Stage::kSimplex:
    case Stage::kLines:
    case Stage::kKicks:
    case Stage::kFollowing:
    case Stage::kRefinements: state.step = SearchStep::kAccelerate; break;
    case Stage::kMigrants: state.step = SearchStep::kMigrate; break;
  }
  return state;
}

void Dvhde::AskInitial() {
  const std::size_t count = members_ * static_cast<std::size_t>(options_.draws_per_member);
  for (std::size_t i = 0; i < count; ++i) {
    Draws draws = DrawsFor(DrawPurpose::kInitial, i);
    asked_.push_back(RandomPoint(*lattice_, draws));
  }
}

/// The best of the points asked for become the population.
void Dvhde::Keep(const std::vector<Score>& scores) {
  population_.clear();
  for (std::size_t i = 0; i < scores.size(); ++i) {
    population_.push_back({asked_[i], scores[i]});
    elites_.Add(population_.back());
    tried_.insert(asked_[i]);
  }
  if (population_.size() > members_) {
    std::stable_sort(population_.begin(), population_.end(),
                     [](const Individual& a, const Individual& b) { return IsBetter(a.score, b.score); });
    population_.resize(members_);
  }
  if (record_.point.empty() || IsBetter(Best().score, record_.score)) record_ = Best();
  reference_ = Best().score;
}

void Dvhde::AskTrials() {
  stage_ = Stage::kTrials;
  ++generation_;
  previous_ = Best().score;
  const double generation_factor = DrawsFor(DrawPurpose::kFactor, 0).Uniform();
  asked_.clear();
  std::size_t fresh = 0;
  for (std::size_t i = 0; i < population_.size(); ++i) {
    Draws draws = DrawsFor(DrawPurpose::kTrial, i);
    asked_.push_back(Trial(i, generation_factor, draws));
    fresh += tried_.insert(asked_.back()).second;
  }
  evolved_ += static_cast<double>(fresh);
  // Points that are known cost nothing, so that a generation of them shows little.
  constexpr double kOfKnown = 0.02;
  generation_weight_ =
      options_.count_new_trials ? static_cast<double>(fresh) / static_cast<double>(population_.size()) + kOfKnown : 1;
}

LatticePoint Dvhde::Trial(std::size_t parent, double generation_factor, Draws& draws) const {
  LatticePoint mutant;
  const double chance = options_.elite_chance * std::min(1.0, stagnation_ / 2);
  if (elites_.best().size() >= 4 && draws.Uniform() < chance) {
    mutant = TrialOfElites(draws);
  } else if (options_.base == MutationBase::kTowardsBest) {
    mutant = TrialTowardsBest(parent, draws);
  } else {
    const auto [base, plus, minus] = PickThree(population_.size(), parent, draws);
    const LatticePoint& start = Point(options_.base == MutationBase::kBest ? BestIndex(population_) : base);
    mutant = Mutate(start, Point(plus), Point(minus), Factors(generation_factor, draws));
  }
  LatticePoint trial = Cross(Point(parent), mutant, options_.crossover, options_.forced_gene, draws);
  Repair(*lattice_, trial, draws);
  return trial;
}

LatticePoint Dvhde::TrialTowardsBest(std::size_t parent, Draws& draws) const {
  const auto [plus, minus, start] = PickThree(population_.size(), parent, draws);
  const LatticePoint* last = &Point(minus);
  if (options_.replaced_parents && !replaced_.empty()) {
    const auto members = static_cast<std::int64_t>(population_.size());
    const std::int64_t k = draws.Integer(0, members + static_cast<std::int64_t>(replaced_.size()) - 1);
    if (k >= members) last = &replaced_[static_cast<std::size_t>(k - members)];
  }
  const std::size_t best = OneOfTheBest(draws);
  return MutateTowards(Point(start), Point(best), Point(plus), *last, TrialFactor(options_.factor, draws));
}

LatticePoint Dvhde::TrialOfElites(Draws& draws) const {
  const Population& elites = elites_.best();
  const auto [plus, minus, start] = PickThree(elites.size(), elites.size(), draws);
  const LatticePoint& best = AnyOf(elites, draws).point;
  return MutateTowards(elites[start].point, best, elites[plus].point, elites[minus].point,
                       TrialFactor(options_.elite_factor, draws));
}

void Dvhde::Select(const std::vector<Score>& scores) {
  state_.accelerated = false;
  state_.migrated = false;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const Individual trial{asked_[i], scores[i]};
    if (options_.elites > 0) elites_.Add(trial);
    if (!IsBetter(trial.score, population_[i].score)) continue;
    if (options_.replaced_parents) replaced_.push_back(population_[i].point);
    population_[i] = trial;
  }
  while (replaced_.size() > population_.size()) replaced_.pop_front();
  if (IsSlow()) Accelerate();
  else EndEvolution();
}

void Dvhde::EndEvolution() {
  const Score best = Best().score;
  if (IsBetter(best, record_.score)) record_ = Best();
  const bool gained = IsBetter(best, previous_);
  state_.stagnant_generations = gained ? 0 : state_.stagnant_generations + 1;
  Score wanted = reference_;
  if (wanted.ok()) wanted.cost *= 1 - options_.least_gain;
  if (IsBetter(best, wanted)) {
    stagnation_ = 0;
    reference_ = best;
  } else {
    stagnation_ += generation_weight_;
  }
  if (NeedsMigration()) return AskMigrants();
  EndGeneration();
}

void Dvhde::AskMigrants() {
  stage_ = Stage::kMigrants;
  const std::size_t best = BestIndex(population_);
  if (options_.keep_best) kept_ = population_[best];
  const auto most = static_cast<std::size_t>(std::max(options_.most_members, options_.population));
  members_ = std::min(most, static_cast<std::size_t>(std::lround(options_.growth * static_cast<double>(members_))));
  const std::size_t count = members_ * static_cast<std::size_t>(options_.draws_per_member);
  const LatticePoint from = options_.keep_best ? Point(best) : record_.point;
  asked_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    if (options_.keep_best && i == best) continue;
    Draws draws = DrawsFor(DrawPurpose::kMigration, i);
    asked_.push_back(Scatter(*lattice_, from, draws));
  }
}

void Dvhde::Migrate(const std::vector<Score>& scores) {
  const std::size_t best = kept_ ? BestIndex(population_) : 0;
  elites_.Clear();
  replaced_.clear();
  line_steps_ = FirstLineSteps(*lattice_);
  const std::size_t members = members_;
  if (kept_) --members_;
  Keep(scores);
  members_ = members;
  if (kept_)
    population_.insert(population_.begin() + static_cast<std::ptrdiff_t>(std::min(best, population_.size())), *kept_);
  kept_.reset();
  reference_ = Best().score;
  state_.migrated = true;
  stagnation_ = 0;
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
  if (options_.acceleration == Acceleration::kLeastSquares)
    return evolved_ >= evolution_due_ || stagnation_ >= options_.migrate_after || IsCollapsed();
  const Score now = Best().score;
  if (!Accelerates() || !previous_.ok()) return false;
  return now.cost > (1 - options_.accelerate_below) * previous_.cost;
}

bool Dvhde::Accelerates() const {
  switch (options_.acceleration) {
    case Acceleration::kSimplex: return options_.simplex_iterations > 0;
    case Acceleration::kPattern: return options_.line_searches + options_.kicks > 0;
    case Acceleration::kLeastSquares: return true;
  }
  return false;
}

bool Dvhde::NeedsMigration() const {
  if (options_.acceleration == Acceleration::kLeastSquares) return false;
  if (options_.migrate_after > 0 && stagnation_ >= options_.migrate_after) return true;
  if (options_.migrate_after > 0 && options_.count_new_trials && IsCollapsed()) return true;
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
  if (options_.factor_rule == MutationFactor::kPerTrial)
    std::fill(factors.begin(), factors.end(), TrialFactor(options_.factor, draws));
  if (options_.factor_rule == MutationFactor::kPerGene) {
    for (double& factor : factors) factor = draws.Uniform();
  }
  return factors;
}

double Dvhde::TrialFactor(double factor, Draws& draws) const {
  return factor + options_.factor_spread * (2 * draws.Uniform() - 1);
}

std::vector<std::size_t> Dvhde::BestFirst() const {
  std::vector<std::size_t> order(population_.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return IsBetter(population_[a].score, population_[b].score); });
  return order;
}

std::size_t Dvhde::OneOfTheBest(Draws& draws) const {
  const auto count =
      std::max<std::int64_t>(1, std::llround(options_.best_share * static_cast<double>(population_.size())));
  return BestFirst()[static_cast<std::size_t>(draws.Integer(0, count - 1))];
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
