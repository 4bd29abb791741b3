#include <algorithm>
#include <cmath>
#include <utility>

#include "identify/search/dvhde.h"
#include "identify/search/dvhde_operators.h"

// How dvHDE accelerates: a simplex, searches along lines and after kicks, or refinements by derivatives.
namespace fourpost {
namespace {

// Of pattern search; all are ratios of steps.
// What is finer is left to the refinement after the search.
constexpr double kLeastLineStep = 1e-7;  // of the range
constexpr double kLineGrowth = 1.5;
constexpr double kLineShrinkage = 0.3;
constexpr double kFirstKickStep = 1.0 / 64;  // of the range
constexpr double kKickGrowth = 2;
constexpr double kKickShrinkage = 0.25;
constexpr int kKickRounds = 4;

// A generation whose best cost falls by this share without kicks needs none.
constexpr double kOwnGain = 1e-3;

// Of a simplex of continuous genes: sizes as shares of the range, at random from the first down to `kLeastSimplex` of
// it; and with how many axes it still gets anywhere.
constexpr double kFirstSimplex = 1.0 / 16;
constexpr double kLeastSimplex = 1e-4;
constexpr std::size_t kMostSimplexAxes = 4;

double RangeOf(const Lattice& lattice, std::size_t axis) { return static_cast<double>(lattice.count(axis) - 1); }

/// The other genes after a kick: discrete ones by whole steps, then the continuous ones, finer and finer.
std::vector<PatternSearch::Walk> WalksAfterKick(const Lattice& lattice, const std::vector<std::size_t>& continuous,
                                                std::size_t kicked, bool with_continuous) {
  std::vector<PatternSearch::Walk> walks;
  for (std::size_t j = 0; j < lattice.size(); ++j)
    if (j != kicked && lattice.axes()[j].discrete) walks.push_back({.axis = j, .step = 1, .growth = kKickGrowth});
  if (!with_continuous) return walks;
  double share = kFirstKickStep;
  for (int round = 0; round < kKickRounds; ++round, share *= kKickShrinkage)
    for (const std::size_t j : continuous)
      walks.push_back({.axis = j, .step = share * RangeOf(lattice, j), .growth = kKickGrowth});
  return walks;
}

}  // namespace

void Dvhde::Accelerate() {
  state_.accelerated = true;
  if (options_.acceleration == Acceleration::kPattern) return AskLines();
  if (options_.acceleration == Acceleration::kLeastSquares) return AskRefinements();
  simplex_.emplace(*lattice_, population_);
  stage_ = Stage::kSimplex;
}

void Dvhde::EndSimplex() {
  // A copy of the best in place of the worst would only cost diversity.
  if (IsBetter(simplex_->best().score, Best().score)) population_[WorstIndex(population_)] = simplex_->best();
  EndEvolution();
}

void Dvhde::AskLines() {
  stage_ = Stage::kLines;
  std::vector<PatternSearch::Walk> walks;
  for (int k = 0; k < options_.line_searches && !continuous_.empty(); ++k) {
    const std::size_t axis = continuous_[(line_turn_ + static_cast<std::size_t>(k)) % continuous_.size()];
    walks.push_back({.axis = axis, .step = line_steps_[axis], .growth = kLineGrowth});
  }
  line_axes_.clear();
  for (const PatternSearch::Walk& walk : walks) line_axes_.push_back(walk.axis);
  pattern_.emplace(*lattice_, Best(), std::move(walks));
  if (pattern_->Ask()) AskOne();
  else EndLines();
}

void Dvhde::EndLines() {
  for (std::size_t k = 0; k < pattern_->ended().size(); ++k) {
    const PatternSearch::Ended& walk = pattern_->ended()[k];
    const std::size_t axis = line_axes_[k];
    line_steps_[axis] = std::max(
        {walk.helped ? walk.step : kLineShrinkage * walk.step, kLeastLineStep * RangeOf(*lattice_, axis), 0.5});
  }
  line_turn_ += pattern_->ended().size();
  population_[BestIndex(population_)] = pattern_->best();
  kicks_done_ = 0;
  Score wanted = previous_;
  if (wanted.ok()) wanted.cost *= 1 - kOwnGain;
  if (IsBetter(Best().score, wanted)) return EndEvolution();
  AskKick();
}

void Dvhde::AskKick() {
  const bool is_mixed = !continuous_.empty() && !discrete_.empty();
  if ((!is_mixed && !HasSimplex()) || kicks_done_ == options_.kicks) return EndEvolution();
  Draws draws = DrawsFor(DrawPurpose::kLine, static_cast<std::size_t>(kicks_done_));
  ++kicks_done_;
  kicked_ = draws.Uniform() < 0.5 ? BestIndex(population_) : OneOfTheBest(draws);
  simplex_share_ = kFirstSimplex * std::pow(kLeastSimplex, draws.Uniform());
  const std::size_t places = discrete_.size() + (HasSimplex() ? continuous_.size() : 0);
  const auto place = static_cast<std::size_t>(draws.Integer(0, static_cast<std::int64_t>(places) - 1));
  if (!is_mixed || place >= discrete_.size()) return Follow(population_[kicked_]);
  stage_ = Stage::kKicks;
  const std::size_t axis = discrete_[place];
  LatticePoint point = Point(kicked_);
  const int direction = draws.Uniform() < 0.5 ? -1 : 1;
  const auto is_in = [&](std::int64_t gene) { return gene >= 1 && gene <= lattice_->count(axis); };
  point[axis] += is_in(point[axis] + direction) ? direction : -direction;
  pattern_.emplace(*lattice_, std::move(point), WalksAfterKick(*lattice_, continuous_, axis, !HasSimplex()));
  AskOne();
}

void Dvhde::EndKick() {
  if (HasSimplex()) return Follow(pattern_->best());
  if (IsBetter(pattern_->best().score, population_[kicked_].score)) population_[kicked_] = pattern_->best();
  AskKick();
}

bool Dvhde::HasSimplex() const { return continuous_.size() > 1 && continuous_.size() <= kMostSimplexAxes; }

void Dvhde::Follow(const Individual& from) {
  stage_ = Stage::kFollowing;
  simplex_.emplace(*lattice_, from, continuous_, simplex_share_);
}

void Dvhde::EndFollowing() {
  if (IsBetter(simplex_->best().score, population_[kicked_].score)) population_[kicked_] = simplex_->best();
  AskKick();
}

/// Of the best members those that are far from where refinements have been.
void Dvhde::AskRefinements() {
  std::vector<LatticePoint> known = refined_;
  for (const std::size_t i : BestFirst()) {
    const bool is_far = std::all_of(known.begin(), known.end(), [&](const LatticePoint& other) {
      return LatticeDistance(*lattice_, Point(i), other) > options_.refine_apart;
    });
    if (!is_far || !population_[i].score.ok()) continue;
    known.push_back(Point(i));
    refined_from_.push_back(Point(i));
    refined_members_.push_back(i);
    if (refined_from_.size() == static_cast<std::size_t>(options_.refinements)) break;
  }
  if (refined_from_.empty()) return EndEvolution();
  stage_ = Stage::kRefinements;
  asked_.clear();
}

/// Low costs may all lead to one optimum that is not the best.
void Dvhde::AskRandomRefinements() {
  for (std::size_t k = 0; k < static_cast<std::size_t>(options_.random_starts); ++k) {
    Draws draws = DrawsFor(DrawPurpose::kStart, k);
    refined_from_.push_back(RandomPoint(*lattice_, draws));
  }
}

void Dvhde::TellRefined(const Population& found, std::int64_t evaluations) {
  const bool from_members = !refined_members_.empty();
  for (std::size_t k = 0; k < found.size(); ++k) {
    refined_.push_back(refined_from_[k]);
    refined_.push_back(found[k].point);
    if (IsBetter(found[k].score, record_.score)) record_ = found[k];
    if (!from_members) continue;
    Individual& member = population_[refined_members_[k]];
    if (IsBetter(found[k].score, member.score)) member = found[k];
  }
  refined_from_.clear();
  refined_members_.clear();
  if (from_members) evolution_due_ = options_.evolution_share * static_cast<double>(evaluations);
  if (from_members && options_.random_starts > 0) return AskRandomRefinements();
  if (IsBetter(Best().score, record_.score)) record_ = Best();
  evolved_ = 0;
  // Nothing is left to gain near by.
  if (options_.migrate_after > 0) AskMigrants();
  else EndEvolution();
}

void Dvhde::AskOne() { asked_ = {*pattern_->Ask()}; }

}  // namespace fourpost
