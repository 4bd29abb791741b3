#include "identify/archive.h"

#include <algorithm>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <unordered_set>
#include <utility>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include "analysis/option_check.h"
#include "identify/draws.h"

namespace fourpost {
namespace {

int ThreadCount(int threads) {
  RequireOption(threads >= 0, "threads", threads, "0 or more");
  return threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// TBB's threads outlive a batch, so a model kept per thread is built once.
template <typename Body>
void ForEach(std::size_t count, int threads, const Body& body) {
  if (threads == 1 || count == 1) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  // More threads than processors, too, when they are asked for.
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([&] {
    // One evaluation per task: their times differ widely.
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
        },
        tbb::simple_partitioner());
  });
}

Score ScoreOf(const Evaluation& evaluation) {
  if (!evaluation.ok()) return {0, evaluation.failure};
  return {evaluation.cost(), Failure::kNone};
}

}  // namespace

bool IsBetter(const Score& a, const Score& b) {
  if (!a.ok()) return false;
  return !b.ok() || a.cost < b.cost;
}

std::int64_t EvaluationCounts::failed() const {
  std::int64_t sum = 0;
  for (const auto& [failure, tally] : failures) sum += tally.count;
  return sum;
}

std::size_t Archive::PointHash::operator()(const LatticePoint& point) const {
  std::uint64_t hash = 0;
  for (const std::int64_t index : point) hash = MixBits(hash ^ static_cast<std::uint64_t>(index));
  return static_cast<std::size_t>(hash);
}

Archive::Archive(Problem problem, int threads) : problem_(std::move(problem)), threads_(ThreadCount(threads)) {}

std::vector<Score> Archive::Evaluate(const std::vector<LatticePoint>& batch) {
  const std::vector<LatticePoint> points = NewPoints(batch);
  std::vector<Eigen::VectorXd> values;
  for (const LatticePoint& point : points) values.push_back(lattice().Values(point));
  const std::vector<Evaluation> evaluations = EvaluateValues(values);
  for (std::size_t i = 0; i < points.size(); ++i) scores_.emplace(points[i], ScoreOf(evaluations[i]));
  counts_.reused += static_cast<std::int64_t>(batch.size() - points.size());

  std::vector<Score> scores;
  for (const LatticePoint& point : batch) scores.push_back(scores_.at(point));
  return scores;
}

std::vector<Evaluation> Archive::EvaluateValues(const std::vector<Eigen::VectorXd>& batch) {
  std::vector<Evaluation> evaluations(batch.size());
  ForEach(batch.size(), threads_, [&](std::size_t i) { evaluations[i] = EvaluateGuarded(problem_, batch[i]); });
  for (Evaluation& evaluation : evaluations) {
    CheckSize(evaluation);
    Count(evaluation);
  }
  return evaluations;
}

std::optional<Score> Archive::Find(const LatticePoint& point) const {
  const auto found = scores_.find(point);
  if (found == scores_.end()) return std::nullopt;
  return found->second;
}

std::vector<Candidate> Archive::Best(int count, double separation) const {
  using Entry = std::pair<const LatticePoint, Score>;
  std::vector<const Entry*> entries;
  for (const Entry& entry : scores_) {
    if (entry.second.ok()) entries.push_back(&entry);
  }
  std::sort(entries.begin(), entries.end(), [](const Entry* a, const Entry* b) {
    return std::tie(a->second.cost, a->first) < std::tie(b->second.cost, b->first);
  });

  std::vector<Candidate> best;
  for (const Entry* entry : entries) {
    if (static_cast<int>(best.size()) >= count) break;
    const bool apart = std::all_of(best.begin(), best.end(), [&](const Candidate& better) {
      return LatticeDistance(lattice(), better.point, entry->first) > separation;
    });
    if (apart) best.push_back({entry->first, lattice().Values(entry->first), entry->second.cost});
  }
  return best;
}

std::vector<LatticePoint> Archive::NewPoints(const std::vector<LatticePoint>& batch) const {
  std::vector<LatticePoint> points;
  std::unordered_set<LatticePoint, PointHash> seen;
  for (const LatticePoint& point : batch) {
    if (!scores_.contains(point) && seen.insert(point).second) points.push_back(point);
  }
  return points;
}

void Archive::CheckSize(Evaluation& evaluation) {
  if (!evaluation.ok()) return;
  const Eigen::Index size = evaluation.residuals.size();
  if (residual_count_ == 0) residual_count_ = size;
  if (size == residual_count_) return;
  evaluation =
      Failed(Failure::kWrongSize, std::to_string(size) + " residuals, elsewhere " + std::to_string(residual_count_));
}

void Archive::Count(const Evaluation& evaluation) {
  ++counts_.paid;
  if (evaluation.ok()) return;
  FailureTally& tally = counts_.failures[evaluation.failure];
  if (tally.count++ == 0) tally.example = evaluation.detail;
}

}  // namespace fourpost
