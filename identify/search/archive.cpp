#include "identify/search/archive.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <mutex>
#include <new>
#include <stdexcept>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "identify/search/draws.h"
#include "identify/search/parallel.h"

namespace fourpost {
namespace {

Score ScoreOf(const Evaluation& evaluation) {
  if (!evaluation.ok()) return {.failure = evaluation.failure, .violation = evaluation.violation};
  return {.cost = evaluation.cost()};
}

}  // namespace

bool IsBetter(const Score& a, const Score& b) {
  if (a.ok()) return !b.ok() || a.cost < b.cost;
  if (b.ok() || a.violation == 0) return false;
  return b.violation == 0 || a.violation < b.violation;
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

Archive::Archive(Problem problem, int threads, EvaluationStore* store, Repeats repeats)
    : problem_(std::move(problem)), threads_(ThreadCount(threads)), store_(store), repeats_(repeats) {}

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
  std::vector<Evaluation> evaluations = EvaluateUnshifted(batch);
  if (shift_.size() > 0)
    for (Evaluation& evaluation : evaluations)
      if (evaluation.ok()) evaluation.residuals += shift_;
  return evaluations;
}

std::vector<Evaluation> Archive::EvaluateUnshifted(const std::vector<Eigen::VectorXd>& batch) {
  std::vector<Eigen::VectorXd> values;
  for (const Eigen::VectorXd& asked : batch) values.push_back(lattice().RoundDiscrete(asked));
  if (store_ != nullptr) return EvaluateStored(values);
  std::vector<Evaluation> evaluations;
  for (EvaluationStore::Answer& answer : AskAll(values)) {
    CheckSize(answer.evaluation);
    Count(values[evaluations.size()], answer.evaluation);
    evaluations.push_back(std::move(answer.evaluation));
  }
  return evaluations;
}

// Each distinct point once.
std::vector<Evaluation> Archive::EvaluateStored(const std::vector<Eigen::VectorXd>& batch) {
  std::unordered_map<std::string, std::size_t> place_of;
  std::vector<Eigen::VectorXd> distinct;
  std::vector<std::size_t> place;
  for (const Eigen::VectorXd& values : batch) {
    const auto [found, is_new] = place_of.emplace(BytesOf(values), distinct.size());
    if (is_new) distinct.push_back(values);
    place.push_back(found->second);
  }
  std::vector<EvaluationStore::Answer> answers = AskAll(distinct);
  for (EvaluationStore::Answer& answer : answers) CheckSize(answer.evaluation);

  std::vector<Evaluation> evaluations;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const EvaluationStore::Answer& answer = answers[place[i]];
    const bool is_first = needed_.insert(BytesOf(batch[i])).second;
    counts_.restored += is_first && answer.was_stored;
    if (is_first || repeats_ == Repeats::kPaid) Count(batch[i], answer.evaluation);
    else ++counts_.reused;
    evaluations.push_back(answer.evaluation);
  }
  return evaluations;
}

EvaluationStore::Answer Archive::Ask(const Eigen::VectorXd& values) const {
  const auto evaluate = [&] { return EvaluateGuarded(problem_, values); };
  if (store_ == nullptr) return {evaluate()};
  return store_->FindOrEvaluate(values, evaluate);
}

std::vector<EvaluationStore::Answer> Archive::AskAll(const std::vector<Eigen::VectorXd>& points) const {
  std::vector<EvaluationStore::Answer> answers(points.size());
  std::mutex telling;
  std::int64_t done = 0;
  ForEachInParallel(points.size(), threads_, [&](std::size_t i) {
    answers[i] = Ask(points[i]);
    const std::lock_guard lock(telling);
    ++done;
    if (tell_) tell_(done);
    if (stop_ && stop_()) throw BatchStopped();
  });
  return answers;
}

std::optional<Eigen::MatrixXd> Archive::Differentiate(const Eigen::VectorXd& values) {
  if (!problem_.differentiate) return std::nullopt;
  const Eigen::Index n = values.size();
  const auto differentiate = [&] {
    Problem columns = problem_;
    columns.evaluate = [&](const Eigen::VectorXd& at) {
      return Evaluation{.residuals = problem_.differentiate(at).reshaped()};
    };
    return EvaluateGuarded(columns, values);
  };
  // Stored as the evaluation of a point that is none: one component more.
  Eigen::VectorXd key(n + 1);
  key << values, std::numeric_limits<double>::quiet_NaN();
  EvaluationStore::Answer answer;
  ForEachInParallel(1, threads_, [&](std::size_t) {
    if (store_ == nullptr) answer.evaluation = differentiate();
    else answer = store_->FindOrEvaluate(key, differentiate);
  });
  const bool is_first = store_ == nullptr || needed_.insert(BytesOf(key)).second || repeats_ == Repeats::kPaid;
  if (is_first) {
    counts_.paid += n;
    if (answer.was_stored) counts_.restored += n;
  } else {
    counts_.reused += n;
  }
  const Eigen::VectorXd& columns = answer.evaluation.residuals;
  if (!answer.evaluation.ok() || columns.size() % n != 0) return std::nullopt;
  if (residual_count_ != 0 && columns.size() != residual_count_ * n) return std::nullopt;
  return columns.reshaped(columns.size() / n, n);
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

void Archive::Count(const Eigen::VectorXd& values, const Evaluation& evaluation) {
  ++counts_.paid;
  if (evaluation.ok()) {
    const double cost = evaluation.cost();
    if (improvements_.empty() || cost < improvements_.back().cost) improvements_.push_back({counts_.paid, cost});
    const double watched = watched_ ? watched_(evaluation.residuals) : cost;
    if (watched < best_cost_) {
      best_cost_ = watched;
      best_values_ = values;
    }
    return;
  }
  FailureTally& tally = counts_.failures[evaluation.failure];
  if (tally.count++ == 0) tally.example = evaluation.detail;
}

}  // namespace fourpost
