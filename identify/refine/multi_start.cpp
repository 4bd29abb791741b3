#include "identify/refine/multi_start.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

#include "analysis/text/option_check.h"
#include "identify/refine/quasi_newton.h"
#include "identify/search/dvhde_operators.h"
#include "identify/search/elites.h"

namespace fourpost {
namespace {

/// A method of which the best points are kept.
class RecordedMethod : public SearchMethod {
 public:
  explicit RecordedMethod(SearchMethod& method) : method_(method) {}

  const std::vector<LatticePoint>& Ask() const override { return method_.Ask(); }
  void Tell(const std::vector<Score>& scores) override {
    const std::vector<LatticePoint> asked = method_.Ask();
    for (std::size_t i = 0; i < scores.size(); ++i) elites_.Add({asked[i], scores[i]});
    method_.Tell(scores);
  }
  bool EndsGeneration() const override { return method_.EndsGeneration(); }
  MethodState state() const override { return method_.state(); }

  const Population& best() const { return elites_.best(); }

 private:
  SearchMethod& method_;
  Elites elites_ = Elites(100);
};

class MultiStart {
 public:
  MultiStart(Archive& archive, const MultiStartOptions& options, std::uint64_t seed, const StopRules& rules,
             const SearchHooks& hooks)
      : archive_(archive), options_(options), seed_(seed), rules_(rules), hooks_(hooks), before_(archive.counts()) {}

  SearchResult Run() {
    while (!Ended()) {
      if (starts_.empty()) Explore();
      if (Ended()) break;
      Refine();
      ++refined_;
      Log();
    }
    result_.end = end_;
    result_.reason = Reason();
    if (result_.log.empty()) Log();
    return result_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void Explore() {
    ++explorations_;
    starts_ = options_.explore_evaluations > 0 ? ExploredStarts() : RandomStart();
    // The best one last, where it is taken from.
    std::reverse(starts_.begin(), starts_.end());
  }

  std::vector<Eigen::VectorXd> RandomStart() {
    std::vector<LatticePoint> points;
    for (std::size_t i = 0; i < static_cast<std::size_t>(options_.scouts); ++i) {
      Draws draws(seed_, DrawPurpose::kStart, explorations_, i);
      points.push_back(RandomPoint(archive_.lattice(), draws));
    }
    // A lone point is evaluated by the refinement itself.
    if (points.size() == 1) return {archive_.lattice().Values(points.front())};
    const std::vector<Score> scores = archive_.Evaluate(points);
    std::size_t best = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (IsBetter(scores[i], scores[best])) best = i;
    }
    return {archive_.lattice().Values(points[best])};
  }

  std::vector<Eigen::VectorXd> ExploredStarts() {
    const std::uint64_t seed = MixBits(seed_ ^ MixBits(static_cast<std::uint64_t>(explorations_)));
    if (options_.explorer == Explorer::kCmaes) {
      Cmaes cmaes(archive_.lattice(), options_.explore_cmaes, seed);
      return StartsOf(cmaes);
    }
    Dvhde dvhde(archive_.lattice(), options_.explore, seed);
    return StartsOf(dvhde);
  }

  /// Of this exploration only: what came before has been refined.
  std::vector<Eigen::VectorXd> StartsOf(SearchMethod& method) {
    RecordedMethod recorded(method);
    StopRules rules = rules_;
    const std::int64_t wanted = options_.explore_evaluations << std::min(explorations_ - 1, 20);
    rules.max_evaluations = std::min(wanted, rules_.max_evaluations - Paid());
    rules.max_generations = std::numeric_limits<int>::max();
    const CandidateRules apart = {.count = options_.starts_each};
    RunSearch(archive_, recorded, rules, apart,
              {.stop = [this] { return ReachesTarget() || (hooks_.stop && hooks_.stop()); }});
    std::vector<LatticePoint> points;
    for (const Individual& member : recorded.best()) {
      const bool far = std::all_of(points.begin(), points.end(), [&](const LatticePoint& better) {
        return LatticeDistance(archive_.lattice(), better, member.point) > apart.separation;
      });
      if (far && static_cast<int>(points.size()) < apart.count) points.push_back(member.point);
    }
    std::vector<Eigen::VectorXd> starts;
    for (const LatticePoint& point : points) starts.push_back(archive_.lattice().Values(point));
    return starts;
  }

  void Refine() {
    const Eigen::VectorXd start = starts_.back();
    starts_.pop_back();
    const std::function<bool()> stop = [this] { return Ended(); };
    if (options_.descent == Descent::kQuasiNewton) MinimiseQuasiNewton(archive_, start, options_.refine, stop);
    else fourpost::Refine(archive_, start, options_.refine, stop);
  }

  bool Ended() {
    if (end_ != SearchEnd::kNotRun) return true;
    if (ReachesTarget()) end_ = SearchEnd::kTarget;
    else if (Paid() >= rules_.max_evaluations) end_ = SearchEnd::kEvaluations;
    else if (Seconds() >= rules_.max_seconds) end_ = SearchEnd::kOutOfTime;
    else if (refined_ >= rules_.max_generations) end_ = SearchEnd::kGenerations;
    else if (options_.starts > 0 && refined_ >= options_.starts) end_ = SearchEnd::kFinished;
    else if (hooks_.stop && hooks_.stop()) end_ = SearchEnd::kStopped;
    return end_ != SearchEnd::kNotRun;
  }

  double Best() const {
    const auto& improvements = archive_.improvements();
    return improvements.empty() ? std::numeric_limits<double>::infinity() : improvements.back().cost;
  }

  bool ReachesTarget() const { return rules_.target_cost && Best() <= *rules_.target_cost; }

  void Log() {
    const EvaluationCounts& counts = archive_.counts();
    const SearchGeneration generation = {.generation = refined_,
                                         .best_cost = Best(),
                                         .paid = Paid(),
                                         .reused = counts.reused - before_.reused,
                                         .failed = counts.failed() - before_.failed()};
    result_.log.push_back(generation);
    if (hooks_.progress) hooks_.progress(generation);
  }

  std::string Reason() const {
    std::ostringstream text;
    text << SearchEndName(end_) << ": ";
    if (end_ == SearchEnd::kTarget) text << Best() << " for " << *rules_.target_cost << ", ";
    text << refined_ << " refinements, " << Paid() << " of " << rules_.max_evaluations << " evaluations";
    return text.str();
  }

  double Seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  std::int64_t Paid() const { return archive_.counts().paid - before_.paid; }

  Archive& archive_;
  const MultiStartOptions& options_;
  std::uint64_t seed_;
  const StopRules& rules_;
  const SearchHooks& hooks_;
  const EvaluationCounts before_;
  const Clock::time_point start_ = Clock::now();
  std::vector<Eigen::VectorXd> starts_;
  int explorations_ = 0;
  int refined_ = 0;
  SearchEnd end_ = SearchEnd::kNotRun;
  SearchResult result_;
};

}  // namespace

void MultiStartOptions::Validate() const {
  refine.Validate();
  explore.Validate();
  explore_cmaes.Validate();
  RequireOption(scouts >= 1, "scouts", scouts, "1 or more");
  RequireOption(explore_evaluations >= 0, "explore_evaluations", explore_evaluations, "0 or more");
  RequireOption(starts_each >= 1, "starts_each", starts_each, "1 or more");
  RequireOption(starts >= 0, "starts", starts, "0 or more");
}

SearchResult RunMultiStart(Archive& archive, const MultiStartOptions& options, std::uint64_t seed,
                           const StopRules& rules, const CandidateRules& candidates, const SearchHooks& hooks) {
  options.Validate();
  rules.Validate();
  candidates.Validate();
  SearchResult result = MultiStart(archive, options, seed, rules, hooks).Run();
  result.candidates = archive.Best(candidates.count, candidates.separation);
  return result;
}

}  // namespace fourpost
