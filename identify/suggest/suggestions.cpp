#include "identify/suggest/suggestions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "identify/search/parallel.h"
#include "identify/suggest/fitted_study.h"
#include "identify/suggest/joined_additions.h"
#include "identify/suggest/trial_list.h"

namespace fourpost {
namespace {

using Eigen::Index;

constexpr double kAlike = 0.95;

/// Says of tested additions what they would change, each alone and together.
class Suggester {
 public:
  Suggester(const FittedStudy& study, TrialList& trials) : study_(study), fitted_(study.fitted()), trials_(trials) {}

  Suggestions Run(const WorkHooks& hooks) {
    trials_.Test();
    const std::vector<Trial*> list = trials_.Best();
    result_.is_interrupted = hooks.IsStopped();
    DescribePoint();
    const JoinedAdditions joined = Joined(list);
    const std::vector<Trial*> best = BestOfEach(list, joined);
    Describe(best);
    Join(list, joined, best);
    for (const Trial& trial : trials_.all())
      if (!trial.test) result_.failed.push_back({trial.addition.words, trial.failure});
    return std::move(result_);
  }

 private:
  void DescribePoint() {
    const FittedPoint& point = fitted_.point();
    result_.cost = point.loss.Cost(point.residuals);
    result_.residuals = study_.measured_count();
    result_.effective = study_.Effective(point.residuals);
    result_.tried = trials_.all().size();
    result_.evaluations = study_.evaluations() + trials_.evaluations();
  }

  SuggestedAddition Described(const Trial& trial) const {
    SuggestedAddition one{.addition = trial.addition, .amount = trial.test->amount};
    if (!trial.values.empty()) one.values = trial.values;
    else if (one.addition.values) one.values = one.addition.values(one.amount);
    one.others = trial.test->is_confirmed ? study_.Moved(study_.x(), trial.test->step) : study_.values();
    one.cost = trial.test->cost;
    one.fall = 1 - trial.test->cost / study_.base().cost;
    one.criterion = trials_.CriterionOf(trial);
    one.effective = study_.Effective(trial.test->left);
    one.moved = MovedBy(MoveOf(*trial.test));
    return one;
  }

  void Describe(const std::vector<Trial*>& list) {
    for (const Trial* trial : list) result_.list.push_back(Described(*trial));
    const std::size_t worthwhile = result_.Worthwhile();
    // What each changes in the residuals beyond what the variables could.
    std::vector<Eigen::VectorXd> beyond(worthwhile);
    for (std::size_t i = 0; i < worthwhile; ++i)
      beyond[i] = fitted_.Weighted(fitted_.Remainder(list[i]->test->alone - fitted_.point().residuals));
    for (std::size_t i = 0; i < worthwhile; ++i)
      for (std::size_t k = 0; k < worthwhile; ++k) {
        const Eigen::VectorXd& a = beyond[i];
        const Eigen::VectorXd& b = beyond[k];
        if (i != k && std::abs(a.dot(b)) > kAlike * a.norm() * b.norm()) result_.list[i].like.push_back(k);
      }
  }

  /// Of the variables by an addition alone: without what they would move without it.
  Eigen::VectorXd MoveOf(const ScoreTest& test) const {
    if (test.step.isZero(0)) return test.step;
    return test.step - study_.base().step;
  }

  /// Of those that were confirmed. Errors within the stated ones may well have a pattern: it cannot be held against the
  /// model, but parameters follow it.
  JoinedAdditions Joined(const std::vector<Trial*>& list) const {
    std::vector<OfferedAddition> offered;
    std::vector<std::size_t> confirmed;
    std::map<std::string, std::size_t> things;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (!list[i]->test->is_confirmed) continue;
      const std::size_t thing = things.try_emplace(list[i]->addition.Key(), things.size()).first->second;
      offered.push_back({fitted_.Weighted(list[i]->test->left), thing});
      confirmed.push_back(i);
    }
    const auto change = [&](double before, const Eigen::VectorXd& left, std::size_t place) {
      // No number of residuals to compare the cost with: see CriterionChange().
      constexpr Index kNone = 0;
      const double effective = study_.EffectiveOfWeighted(left);
      const Addition& addition = list[confirmed[place]]->addition;
      return CriterionChange(before, left.squaredNorm(), kNone, effective, addition.count, result_.tried,
                             addition.choices);
    };
    JoinedAdditions joined = JoinAdditions(fitted_.Weighted(study_.base().left), offered, change);
    for (std::size_t& place : joined.places) place = confirmed[place];
    return joined;
  }

  /// Of all alternatives for a thing the one that explains the residuals together with other things, else the best.
  static std::vector<Trial*> BestOfEach(const std::vector<Trial*>& list, const JoinedAdditions& joined) {
    std::map<std::string, Trial*> of_thing;
    for (const std::size_t place : joined.places) of_thing[list[place]->addition.Key()] = list[place];
    for (Trial* trial : list) of_thing.try_emplace(trial->addition.Key(), trial);
    std::vector<Trial*> best;
    for (Trial* trial : list)
      if (of_thing[trial->addition.Key()] == trial) best.push_back(trial);
    return best;
  }

  void Join(const std::vector<Trial*>& list, const JoinedAdditions& joined, const std::vector<Trial*>& best) {
    if (result_.is_interrupted) return;
    result_.jacobian = fitted_.point().jacobian;
    result_.left_together = study_.base().left;
    Eigen::MatrixXd moved(study_.values().size(), std::ssize(joined.places));
    for (Index k = 0; k < moved.cols(); ++k) {
      Trial* trial = list[joined.places[static_cast<std::size_t>(k)]];
      const auto place = static_cast<std::size_t>(std::find(best.begin(), best.end(), trial) - best.begin());
      result_.together.push_back(place);
      result_.list[place].worth = joined.worth[static_cast<std::size_t>(k)];
      result_.left_together += joined.shares[k] * (trial->test->left - study_.base().left);
      moved.col(k) = joined.shares[k] * MoveOf(*trial->test);
    }
    result_.moved_together = WithinBounds(moved);
    result_.moves_together = MovedBy(result_.moved_together.rowwise().sum());
  }

  /// Moves that add up to no more than the bounds let, as they limit what was evaluated.
  Eigen::MatrixXd WithinBounds(Eigen::MatrixXd moved) const {
    const Eigen::VectorXd x = study_.x();
    for (Index j = 0; j < moved.rows(); ++j) {
      const double sum = moved.row(j).sum();
      const double to = std::clamp(x[j] + sum, study_.variables().lower()[j], study_.variables().upper()[j]) - x[j];
      if (to != sum) moved.row(j) *= to / sum;
    }
    return moved;
  }

  std::vector<MovedParameter> MovedBy(const Eigen::VectorXd& step) const {
    constexpr double kLeast = 0.01;
    const Eigen::VectorXd moved = study_.Moved(study_.x(), step);
    std::vector<MovedParameter> list;
    for (Index j = 0; j < step.size(); ++j) {
      const Parameter& parameter = study_.study().vehicle.parameters[study_.study().free[static_cast<std::size_t>(j)]];
      const double whole =
          study_.variables().is_logarithmic(j) ? study_.values()[j] : parameter.upper - parameter.lower;
      const double share = (moved[j] - study_.values()[j]) / whole;
      if (std::abs(share) >= kLeast) list.push_back({parameter.name, share});
    }
    std::stable_sort(list.begin(), list.end(), [](const MovedParameter& a, const MovedParameter& b) {
      return std::abs(a.share) > std::abs(b.share);
    });
    return list;
  }

  const FittedStudy& study_;
  const FollowedCost& fitted_;
  TrialList& trials_;
  Suggestions result_;
};

}  // namespace

std::size_t Suggestions::Worthwhile() const {
  return static_cast<std::size_t>(
      std::count_if(list.begin(), list.end(), [](const SuggestedAddition& one) { return one.criterion < 0; }));
}

Suggestions SuggestFor(const LoadedStudy& study, const Eigen::VectorXd& values, int threads, const WorkHooks& hooks) {
  const FittedStudy fitted(study, values, ThreadCount(threads));
  TrialList trials(fitted, ThreadCount(threads), hooks);
  return Suggester(fitted, trials).Run(hooks);
}

}  // namespace fourpost
