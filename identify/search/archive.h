#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "identify/search/evaluation.h"
#include "identify/search/evaluation_store.h"
#include "identify/search/lattice.h"

namespace fourpost {

/// What the archive keeps of an evaluation; residuals can be computed again.
struct Score {
  /// Sum of squared residuals; means nothing for a failure.
  double cost = 0;
  Failure failure = Failure::kNone;
  /// Of an infeasible point, see Evaluation.
  double violation = 0;

  bool ok() const { return failure == Failure::kNone; }
  bool operator==(const Score&) const = default;
};

/// Strictly better: a failure is worse than any number. Of failures, infeasible points with a known violation are the
/// better ones, the less violation the better (Deb, Comput. Methods Appl. Mech. Eng. 186, 2000); others are alike.
bool IsBetter(const Score& a, const Score& b);

/// Evaluations of one cause of failure.
struct FailureTally {
  std::int64_t count = 0;
  /// Detail of the first one.
  std::string example;
};

/// Where the evaluations went. The same whatever was stored before, except `restored`.
struct EvaluationCounts {
  /// Evaluations of the model that the run needed: distinct points with a store; without one distinct lattice points,
  /// and all points off the lattice.
  std::int64_t paid = 0;
  /// Requests for a point that was evaluated before.
  std::int64_t reused = 0;
  /// Of the new ones, those that the store had, from an earlier run or one beside: they cost nothing.
  std::int64_t restored = 0;
  /// New evaluations that failed, by cause.
  std::map<Failure, FailureTally> failures;

  std::int64_t failed() const;
};

/// A cost below all before it.
struct Improvement {
  /// New evaluations up to and including this one, in the order of the batches, whatever the threads.
  std::int64_t paid = 0;
  double cost = 0;
};

/// A point and what it costs.
struct Candidate {
  LatticePoint point;
  Eigen::VectorXd values;
  double cost = 0;
};

/// With a store: whether a point off the lattice that a run asks for again counts as new again, as it does without
/// one, so that counts do not depend on whether there is a store.
enum class Repeats { kReused, kPaid };

/// A batch was ended before all of it was evaluated, see Archive::StopBatches. What was evaluated is in the store.
struct BatchStopped {};

/// Evaluates a problem in parallel and remembers every lattice point, so that none is evaluated twice; with a store
/// points off the lattice as well, and across runs. All results and counts are the same for any number of threads and
/// whatever was stored before. To be called from one thread.
class Archive {
 public:
  /// `threads`: how many evaluations run at once; 0 means one per processor. Throws std::invalid_argument for less.
  /// `store`: where evaluations of this problem are kept; may be shared, and must outlive this object.
  explicit Archive(Problem problem, int threads = 1, EvaluationStore* store = nullptr,
                   Repeats repeats = Repeats::kReused);

  const Problem& problem() const { return problem_; }
  const Lattice& lattice() const { return problem_.lattice; }
  const EvaluationCounts& counts() const { return counts_; }
  /// Costs each below the one before, on and off the lattice.
  const std::vector<Improvement>& improvements() const { return improvements_; }
  /// Has each new evaluation measured by another cost than squares as well, such as that of a robust loss.
  void Watch(std::function<double(const Eigen::VectorXd& residuals)> cost) { watched_ = std::move(cost); }
  /// Has it report how many points of a batch are evaluated, after each: by one thread at a time, whichever it is.
  void TellProgress(std::function<void(std::int64_t done)> tell) { tell_ = std::move(tell); }
  /// From now on asks after each point of a batch, one thread at a time, whether to end it by throwing BatchStopped;
  /// nothing: never.
  void StopBatches(std::function<bool()> stop) { stop_ = std::move(stop); }
  /// Adds these to the residuals of each evaluation that is asked for from now on, but not to what is stored or watched:
  /// what is known near a point of the error of all evaluations.
  void ShiftResiduals(Eigen::VectorXd shift) { shift_ = std::move(shift); }
  /// Lowest of all that were watched, of squares where nothing is watched; infinite before the first.
  double best_cost() const { return best_cost_; }
  /// Where that is; empty before the first.
  const Eigen::VectorXd& best_values() const { return best_values_; }
  /// Number of lattice points remembered.
  std::size_t size() const { return scores_.size(); }

  /// Scores in the order of the batch; a point that is there twice is evaluated once.
  /// Throws std::invalid_argument for a point that is not on the lattice, OutputError when the store cannot be written.
  std::vector<Score> Evaluate(const std::vector<LatticePoint>& batch);

  /// Evaluates values anywhere, as refinement needs, discrete ones rounded: without a store always new, not
  /// remembered. Throws OutputError when the store cannot be written.
  std::vector<Evaluation> EvaluateValues(const std::vector<Eigen::VectorXd>& batch);

  /// The model's own derivatives, d residuals / d values; nothing where it has none, or not here. Counted as one
  /// evaluation per parameter, which is what it takes.
  std::optional<Eigen::MatrixXd> Differentiate(const Eigen::VectorXd& values);

  /// The remembered score; nothing for a new point.
  std::optional<Score> Find(const LatticePoint& point) const;

  /// Up to `count` points, best first, each further than `separation` (LatticeDistance) from every better one of them:
  /// starting points for refinement that are not all in one place. Equal costs go by index.
  std::vector<Candidate> Best(int count, double separation) const;

 private:
  struct PointHash {
    std::size_t operator()(const LatticePoint& point) const;
  };

  std::vector<LatticePoint> NewPoints(const std::vector<LatticePoint>& batch) const;
  EvaluationStore::Answer Ask(const Eigen::VectorXd& values) const;
  std::vector<EvaluationStore::Answer> AskAll(const std::vector<Eigen::VectorXd>& points) const;
  std::vector<Evaluation> EvaluateUnshifted(const std::vector<Eigen::VectorXd>& batch);
  std::vector<Evaluation> EvaluateStored(const std::vector<Eigen::VectorXd>& batch);
  // Sums over unlike numbers of residuals cannot be compared: the first evaluation decides how many there are.
  void CheckSize(Evaluation& evaluation);
  void Count(const Eigen::VectorXd& values, const Evaluation& evaluation);

  Problem problem_;
  int threads_;
  EvaluationStore* store_;
  Repeats repeats_;
  // The bytes of all values that this run needed, with a store.
  std::unordered_set<std::string> needed_;
  std::unordered_map<LatticePoint, Score, PointHash> scores_;
  EvaluationCounts counts_;
  std::vector<Improvement> improvements_;
  std::function<double(const Eigen::VectorXd& residuals)> watched_;
  std::function<void(std::int64_t done)> tell_;
  std::function<bool()> stop_;
  // Empty: nothing.
  Eigen::VectorXd shift_;
  double best_cost_ = std::numeric_limits<double>::infinity();
  Eigen::VectorXd best_values_;
  Eigen::Index residual_count_ = 0;
};

}  // namespace fourpost
