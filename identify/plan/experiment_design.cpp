#include "identify/plan/experiment_design.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Cholesky>

namespace fourpost {
namespace {

using Eigen::Index;

double LogDeterminant(const Eigen::MatrixXd& information) {
  return 2 * information.llt().matrixL().toDenseMatrix().diagonal().array().log().sum();
}

Eigen::MatrixXd Inverse(const Eigen::MatrixXd& information) {
  return information.llt().solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
}

class Designer {
 public:
  Designer(const Eigen::MatrixXd& known, const std::vector<PossibleRun>& runs, const DesignGoal& goal)
      : known_(known), runs_(runs), goal_(goal), repeats_(runs.size()), information_(known) {
    for (const PossibleRun& run : runs) {
      std::vector<Eigen::MatrixXd> of_run;
      for (int n = 0; n <= run.most_repeats; ++n) of_run.push_back(run.Information(n));
      informations_.push_back(std::move(of_run));
    }
  }

  ExperimentDesign Run() {
    Add();
    while (Exchange()) Add();
    if (HasTargets()) Prune();
    ExperimentDesign design{.repeats = repeats_, .cost_s = cost_s_, .covariance = Inverse(information_)};
    if (HasTargets()) design.meets = Meets(information_);
    else design.efficiency = Efficiency();
    return design;
  }

 private:
  bool HasTargets() const { return goal_.targets.size() > 0; }

  bool Meets(const Eigen::MatrixXd& information) const {
    return (Inverse(information).diagonal().array() <= goal_.targets.array().square()).all();
  }

  /// Larger is better.
  double Value(const Eigen::MatrixXd& information) const {
    if (!HasTargets()) return LogDeterminant(information);
    const Eigen::ArrayXd variances = Inverse(information).diagonal().array();
    double value = 0;
    for (Index j = 0; j < variances.size(); ++j)
      if (std::isfinite(goal_.targets[j]))
        value -= std::max(0.0, std::log(variances[j] / (goal_.targets[j] * goal_.targets[j])));
    return value;
  }

  Eigen::MatrixXd Step(std::size_t run, int to) const {
    return informations_[run][static_cast<std::size_t>(to)] -
           informations_[run][static_cast<std::size_t>(repeats_[run])];
  }

  void Take(std::size_t run, int to) {
    information_ += Step(run, to);
    cost_s_ += runs_[run].cost_s * (to - repeats_[run]);
    repeats_[run] = to;
  }

  bool IsAffordable(double change_s) const { return cost_s_ + change_s <= goal_.budget_s * (1 + 1e-9); }

  /// The repeat that gives most per second, until none is affordable or all is reached.
  void Add() {
    while (!(HasTargets() && Meets(information_))) {
      const double here = Value(information_);
      std::size_t best = runs_.size();
      double most = 1e-9;
      for (std::size_t c = 0; c < runs_.size(); ++c) {
        if (repeats_[c] >= runs_[c].most_repeats || !IsAffordable(runs_[c].cost_s)) continue;
        const double gain = (Value(information_ + Step(c, repeats_[c] + 1)) - here) / runs_[c].cost_s;
        if (gain * goal_.budget_s > most) {
          most = gain * goal_.budget_s;
          best = c;
        }
      }
      if (best == runs_.size()) return;
      Take(best, repeats_[best] + 1);
    }
  }

  /// One repeat for one of another run.
  bool Exchange() {
    constexpr double kWorthwhile = 1e-6;
    const double here = Value(information_);
    double most = kWorthwhile;
    std::size_t from = runs_.size();
    std::size_t to = runs_.size();
    for (std::size_t a = 0; a < runs_.size(); ++a) {
      if (repeats_[a] == 0) continue;
      const Eigen::MatrixXd without = information_ + Step(a, repeats_[a] - 1);
      for (std::size_t b = 0; b < runs_.size(); ++b) {
        const double change_s = runs_[b].cost_s - runs_[a].cost_s;
        if (b == a || repeats_[b] >= runs_[b].most_repeats || !IsAffordable(change_s)) continue;
        const double gain = Value(without + Step(b, repeats_[b] + 1)) - here;
        if (gain <= most) continue;
        most = gain;
        from = a;
        to = b;
      }
    }
    if (from == runs_.size()) return false;
    Take(from, repeats_[from] - 1);
    Take(to, repeats_[to] + 1);
    return true;
  }

  /// The dearest repeats that the targets do not need.
  void Prune() {
    if (!Meets(information_)) return;
    std::vector<std::size_t> order(runs_.size());
    for (std::size_t c = 0; c < order.size(); ++c) order[c] = c;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return runs_[a].cost_s > runs_[b].cost_s; });
    for (const std::size_t c : order)
      while (repeats_[c] > 0 && Meets(information_ + Step(c, repeats_[c] - 1))) Take(c, repeats_[c] - 1);
  }

  /// The repeats within the budget that are worth most if each gains as much as here: a knapsack of parts.
  Eigen::VectorXd Knapsack(const Eigen::VectorXd& gains) const {
    std::vector<std::size_t> order(runs_.size());
    for (std::size_t c = 0; c < order.size(); ++c) order[c] = c;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return gains[static_cast<Index>(a)] / runs_[a].cost_s > gains[static_cast<Index>(b)] / runs_[b].cost_s;
    });
    Eigen::VectorXd most = Eigen::VectorXd::Zero(gains.size());
    double left_s = goal_.budget_s;
    for (const std::size_t c : order) {
      const double repeats = std::min(static_cast<double>(runs_[c].most_repeats), left_s / runs_[c].cost_s);
      most[static_cast<Index>(c)] = repeats;
      left_s -= repeats * runs_[c].cost_s;
    }
    return most;
  }

  double Efficiency() const {
    constexpr int kIterations = 60;
    const auto p = static_cast<double>(known_.rows());
    const double own = LogDeterminant(information_);
    double bound = std::numeric_limits<double>::infinity();
    Eigen::VectorXd at(std::ssize(runs_));
    for (Index c = 0; c < at.size(); ++c) at[c] = repeats_[static_cast<std::size_t>(c)];
    for (int k = 0; k < kIterations; ++k) {
      Eigen::MatrixXd information = known_;
      for (Index c = 0; c < at.size(); ++c) information += InformationAt(c, at[c]);
      const Eigen::MatrixXd covariance = Inverse(information);
      Eigen::VectorXd gains(at.size());
      for (Index c = 0; c < at.size(); ++c) gains[c] = covariance.cwiseProduct(SlopeAt(c, at[c])).sum();
      const Eigen::VectorXd ahead = Knapsack(gains) - at;
      const double gap = gains.dot(ahead);
      bound = std::min(bound, LogDeterminant(information) + gap);
      // A hundredth of what is worth a word.
      constexpr double kSmall = 1e-4;
      if (gap < kSmall * p) break;
      at += 2.0 / (k + 3) * ahead;
    }
    // The determinant is that of variances.
    return std::exp(-0.5 * std::max(0.0, bound - own) / p);
  }

  /// Whole repeats in a number of them, and one more to be had.
  std::size_t WholeIn(Index run, double repeats) const {
    const int most = runs_[static_cast<std::size_t>(run)].most_repeats;
    return static_cast<std::size_t>(std::min(static_cast<int>(repeats), most - 1));
  }
  Eigen::MatrixXd SlopeAt(Index run, double repeats) const {
    const std::vector<Eigen::MatrixXd>& of_run = informations_[static_cast<std::size_t>(run)];
    const std::size_t whole = WholeIn(run, repeats);
    return of_run[whole + 1] - of_run[whole];
  }
  /// Linear between whole repeats.
  Eigen::MatrixXd InformationAt(Index run, double repeats) const {
    const std::size_t whole = WholeIn(run, repeats);
    return informations_[static_cast<std::size_t>(run)][whole] +
           (repeats - static_cast<double>(whole)) * SlopeAt(run, repeats);
  }

  const Eigen::MatrixXd& known_;
  const std::vector<PossibleRun>& runs_;
  const DesignGoal& goal_;
  std::vector<int> repeats_;
  Eigen::MatrixXd information_;
  double cost_s_ = 0;
  std::vector<std::vector<Eigen::MatrixXd>> informations_;
};

}  // namespace

Eigen::MatrixXd PossibleRun::Information(int repeats) const {
  if (repeats == 0) return Eigen::MatrixXd::Zero(slopes.cols(), slopes.cols());
  const Eigen::VectorXd weights = (noise / repeats + floor).cwiseInverse();
  return slopes.transpose() * weights.asDiagonal() * slopes;
}

ExperimentDesign BestDesign(const Eigen::MatrixXd& known, const std::vector<PossibleRun>& runs,
                            const DesignGoal& goal) {
  ExperimentDesign best = Designer(known, runs, goal).Run();
  // What gives most per second may pass by what is enough; in less time it is exchanged for that.
  constexpr double kLess = 0.97;
  constexpr int kMostFailures = 5;
  DesignGoal shorter = goal;
  shorter.budget_s = best.cost_s;
  for (int failures = 0; goal.targets.size() > 0 && best.meets && best.cost_s > 0 && failures < kMostFailures;) {
    shorter.budget_s *= kLess;
    ExperimentDesign design = Designer(known, runs, shorter).Run();
    if (!design.meets) {
      ++failures;
      continue;
    }
    shorter.budget_s = design.cost_s;
    best = std::move(design);
  }
  return best;
}

Eigen::MatrixXd CovarianceWith(const Eigen::MatrixXd& known, const std::vector<PossibleRun>& runs,
                               const std::vector<int>& repeats) {
  Eigen::MatrixXd information = known;
  for (std::size_t c = 0; c < runs.size(); ++c) information += runs[c].Information(repeats[c]);
  return Inverse(information);
}

}  // namespace fourpost
