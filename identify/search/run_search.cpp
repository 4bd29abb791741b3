#include "identify/search/run_search.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

/// Adds up what the accelerations and the migrations of a run bring; to be given every batch.
class GainTally {
 public:
  /// Before a batch of this step; `best`: the best cost so far.
  void Begin(SearchStep step, double best) {
    if (step != step_ && step_ == SearchStep::kAccelerate) End(accelerations_, before_acceleration_, best);
    if (step != step_ && step == SearchStep::kAccelerate) {
      ++accelerations_.count;
      before_acceleration_ = best;
    }
    if (step == SearchStep::kMigrate) {
      if (migrations_.count > 0) End(migrations_, before_migration_, best);
      ++migrations_.count;
      before_migration_ = best;
    }
    step_ = step;
  }

  /// After it.
  void Pay(std::int64_t evaluations) {
    if (step_ == SearchStep::kAccelerate) accelerations_.evaluations += evaluations;
    if (step_ == SearchStep::kMigrate) migrations_.evaluations += evaluations;
  }

  void Finish(double best, SearchResult& result) {
    if (step_ == SearchStep::kAccelerate) End(accelerations_, before_acceleration_, best);
    if (migrations_.count > 0) End(migrations_, before_migration_, best);
    result.accelerations = accelerations_;
    result.migrations = migrations_;
  }

 private:
  static void End(SearchGain& gain, double before, double after) {
    if (!(after < before)) return;
    ++gain.successes;
    if (std::isfinite(before)) gain.cost_ratio *= after / before;
  }

  SearchStep step_ = SearchStep::kEvolve;
  SearchGain accelerations_;
  SearchGain migrations_;
  double before_acceleration_ = 0;
  double before_migration_ = 0;
};

class SearchRun {
 public:
  SearchRun(Archive& archive, SearchMethod& method, const StopRules& rules, const SearchHooks& hooks)
      : archive_(archive), method_(method), rules_(rules), hooks_(hooks), before_(archive.counts()) {}

  SearchResult Run() {
    while (Step()) {
      if (!method_.EndsGeneration()) continue;
      Log();
      if (EndsAfterGeneration()) break;
    }
    gains_.Finish(BestCost(), result_);
    // What came after the last whole generation.
    if (result_.log.empty() || result_.log.back().paid != Paid() || result_.log.back().best_cost != BestCost()) Log();
    result_.reason = Reason();
    return result_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  // Scores what the method asks for; false when the search ends within or before the batch.
  bool Step() {
    if (EndsBeforeBatch()) return false;
    gains_.Begin(method_.state().step, BestCost());
    const std::int64_t before = Paid();
    const bool goes_on = method_.AskRefined().empty() ? EvaluateAsked() : RefineAsked();
    gains_.Pay(Paid() - before);
    return goes_on;
  }

  bool EvaluateAsked() {
    const std::vector<LatticePoint>& asked = method_.Ask();
    const std::vector<LatticePoint> affordable(asked.begin(), FirstBeyondBudget(asked));
    const std::vector<Score> scores = archive_.Evaluate(affordable);
    for (const Score& score : scores) {
      if (score.ok() && IsBetter(score, best_)) best_ = score;
    }
    if (affordable.size() < asked.size()) return !End(ReachesTarget() ? SearchEnd::kTarget : SearchEnd::kEvaluations);
    if (ReachesTarget()) return !End(SearchEnd::kTarget);
    method_.Tell(scores);
    return true;
  }

  bool RefineAsked() {
    Population found;
    const std::int64_t before = Paid();
    for (const LatticePoint& point : method_.AskRefined()) {
      found.push_back(Refined(point));
      if (IsBetter(found.back().score, best_)) best_ = found.back().score;
      if (MustEnd()) return !EndNow();
    }
    method_.TellRefined(found, Paid() - before);
    return true;
  }

  /// Where a refinement from a point leads, on the lattice; the point itself where the budget ends.
  Individual Refined(const LatticePoint& point) {
    if (!CanRefine()) return {point, archive_.Evaluate({point}).front()};
    const auto stop = [this] { return MustEnd() || !CanRefine(); };
    const LatticePoint near = archive_.lattice().Nearest(hooks_.refine(archive_.lattice().Values(point), stop));
    return {near, archive_.Evaluate({near}).front()};
  }

  /// Whether the budget has an iteration left, derivatives and step, and its end on the lattice.
  bool CanRefine() const {
    return rules_.max_evaluations - Paid() >= static_cast<std::int64_t>(archive_.lattice().size()) + 2;
  }

  /// What ends a search within a refinement.
  bool MustEnd() const { return ReachesTarget() || Seconds() >= rules_.max_seconds || (hooks_.stop && hooks_.stop()); }
  bool EndNow() {
    if (ReachesTarget()) return End(SearchEnd::kTarget);
    return End(Seconds() >= rules_.max_seconds ? SearchEnd::kOutOfTime : SearchEnd::kStopped);
  }

  bool EndsBeforeBatch() {
    if (hooks_.stop && hooks_.stop()) return End(SearchEnd::kStopped);
    if (method_.Ask().empty() && method_.AskRefined().empty())
      return End(method_.state().collapsed ? SearchEnd::kCollapse : SearchEnd::kFinished);
    if (Seconds() >= rules_.max_seconds) return End(SearchEnd::kOutOfTime);
    return false;
  }

  bool EndsAfterGeneration() {
    const MethodState state = method_.state();
    if (ReachesTarget()) return End(SearchEnd::kTarget);
    if (Paid() >= rules_.max_evaluations) return End(SearchEnd::kEvaluations);
    if (state.generation >= rules_.max_generations) return End(SearchEnd::kGenerations);
    free_generations_ = Paid() > paid_last_ ? 0 : free_generations_ + 1;
    paid_last_ = Paid();
    if (free_generations_ >= rules_.max_free_generations) return End(SearchEnd::kNothingNew);
    if (rules_.on_collapse && state.collapsed) return End(SearchEnd::kCollapse);
    const int patience = rules_.max_stagnant_generations;
    if (patience > 0 && state.stagnant_generations >= patience) return End(SearchEnd::kStagnation);
    return false;
  }

  bool End(SearchEnd end) {
    result_.end = end;
    return true;
  }

  /// On the lattice or, by a refinement, off it.
  double BestCost() const {
    const auto& all = archive_.improvements();
    const bool has_new = all.size() > improvements_before_;
    return std::min(best_.ok() ? best_.cost : std::numeric_limits<double>::infinity(),
                    has_new ? all.back().cost : std::numeric_limits<double>::infinity());
  }
  bool ReachesTarget() const { return rules_.target_cost && BestCost() <= *rules_.target_cost; }

  std::vector<LatticePoint>::const_iterator FirstBeyondBudget(const std::vector<LatticePoint>& points) const {
    const std::int64_t left = rules_.max_evaluations - Paid();
    if (static_cast<std::int64_t>(points.size()) <= left) return points.end();
    std::set<LatticePoint> fresh;
    return std::find_if(points.begin(), points.end(), [&](const LatticePoint& point) {
      if (!archive_.Find(point)) fresh.insert(point);
      return static_cast<std::int64_t>(fresh.size()) > left;
    });
  }

  void Log() {
    const EvaluationCounts& counts = archive_.counts();
    const MethodState state = method_.state();
    const SearchGeneration generation = {.generation = state.generation,
                                         .best_cost = BestCost(),
                                         .paid = Paid(),
                                         .reused = counts.reused - before_.reused,
                                         .failed = counts.failed() - before_.failed(),
                                         .diversity = state.diversity,
                                         .accelerated = state.accelerated,
                                         .migrated = state.migrated};
    result_.log.push_back(generation);
    if (hooks_.progress) hooks_.progress(generation);
  }

  std::string Reason() const {
    std::ostringstream text;
    text << SearchEndName(result_.end) << ": ";
    switch (result_.end) {
      case SearchEnd::kTarget: text << BestCost() << " for " << *rules_.target_cost << ", "; break;
      case SearchEnd::kGenerations: text << rules_.max_generations << " generations, "; break;
      case SearchEnd::kOutOfTime: text << Seconds() << " s of " << rules_.max_seconds << " s, "; break;
      case SearchEnd::kStagnation: text << method_.state().stagnant_generations << " generations, "; break;
      case SearchEnd::kNothingNew: text << free_generations_ << " generations without a new point, "; break;
      default: break;
    }
    text << Paid() << " of " << rules_.max_evaluations << " evaluations";
    return text.str();
  }

  double Seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  std::int64_t Paid() const { return archive_.counts().paid - before_.paid; }

  Archive& archive_;
  SearchMethod& method_;
  const StopRules& rules_;
  const SearchHooks& hooks_;
  const EvaluationCounts before_;
  const std::size_t improvements_before_ = archive_.improvements().size();
  const Clock::time_point start_ = Clock::now();
  Score best_ = {std::numeric_limits<double>::infinity(), Failure::kNotFinite};
  GainTally gains_;
  std::int64_t paid_last_ = 0;
  int free_generations_ = 0;
  SearchResult result_;
};

}  // namespace

SearchGain& SearchGain::operator+=(const SearchGain& other) {
  count += other.count;
  evaluations += other.evaluations;
  successes += other.successes;
  cost_ratio *= other.cost_ratio;
  return *this;
}

void CandidateRules::Validate() const {
  RequireOption(count >= 1, "candidates", count, "1 or more");
  RequireOption(separation >= 0 && separation < 1, "candidate_separation", separation, "in [0, 1)");
}

const Candidate& SearchResult::best() const {
  if (candidates.empty()) throw std::logic_error("the search found no point that could be evaluated");
  return candidates.front();
}

SearchResult RunSearch(Archive& archive, SearchMethod& method, const StopRules& rules, const CandidateRules& candidates,
                       const SearchHooks& hooks) {
  rules.Validate();
  candidates.Validate();
  SearchResult result = SearchRun(archive, method, rules, hooks).Run();
  result.candidates = archive.Best(candidates.count, candidates.separation);
  return result;
}

}  // namespace fourpost
