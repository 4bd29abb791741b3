#include "identify/suggest/suggestions.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "identify/refine/difference_jacobian.h"
#include "identify/refine/fit_variables.h"
#include "identify/refine/refine.h"
#include "identify/search/archive.h"
#include "identify/search/parallel.h"
#include "identify/suggest/addition_list.h"
#include "identify/suggest/augmented_study.h"
#include "identify/suggest/findings.h"
#include "identify/suggest/first_look.h"
#include "identify/suggest/joined_additions.h"
#include "identify/suggest/new_numbers.h"
#include "identify/suggest/score_test.h"
#include "vehicles/multibody/simulation_error.h"

namespace fourpost {
namespace {

using Eigen::Index;

constexpr double kAlike = 0.95;
/// Of how many things that could be added an amount is looked for by evaluations, and of how many additions all is
/// evaluated truly.
constexpr std::size_t kEvaluated = 24;
constexpr std::size_t kConfirmed = 12;

/// An addition under test.
struct Trial {
  Addition addition;
  std::unique_ptr<AugmentedStudy> study;
  std::optional<ScoreTest> test;
  /// SI, of its parameters, where they were fitted each on its own.
  std::vector<double> values;
  /// Why there is no test.
  std::string failure;
};

class Suggester {
 public:
  Suggester(const LoadedStudy& study, const Eigen::VectorXd& values, int threads, const WorkHooks& hooks)
      : study_(study),
        values_(values),
        threads_(ThreadCount(threads)),
        hooks_(hooks),
        objective_(study.MakeObjective()),
        variables_(objective_.MakeProblem().lattice),
        structure_(JoinedStructure(objective_.blocks())) {}

  Suggestions Run() {
    const FollowedCost fitted = Fitted();
    base_ = fitted.Of(fitted.point().residuals);
    result_.cost = fitted.point().loss.Cost(fitted.point().residuals);
    result_.residuals = fitted.point().residuals.size() - objective_.prior_count();
    result_.effective = EffectiveOf(fitted, fitted.point().residuals);
    result_.misfit = std::sqrt(fitted.point().residuals.head(result_.residuals).squaredNorm() /
                               std::max(1.0, static_cast<double>(result_.residuals - values_.size())));
    std::vector<Trial> trials = Trials();
    TestAll(fitted, trials);
    std::vector<Trial*> list = Alternatives(fitted, trials);
    Confirm(fitted, list);
    result_.is_interrupted = hooks_.IsStopped();
    LeaveOutParts(list);
    const JoinedAdditions joined = Joined(fitted, list);
    const std::vector<Trial*> best = BestOfEach(list, joined);
    Describe(fitted, best);
    Join(fitted, list, joined, best);
    for (const Trial& trial : trials)
      if (!trial.test) result_.failed.push_back({trial.addition.words, trial.failure});
    return std::move(result_);
  }

 private:
  FollowedCost Fitted() {
    Archive archive(objective_.MakeProblem(), threads_);
    const LossKind kind = study_.study.refine.loss;
    FittedPoint point;
    point.loss = RobustLoss(kind, study_.study.refine.scale.value_or(UsualScale(kind)), objective_.prior_count());
    const Evaluation here = archive.EvaluateValues({values_}).front();
    if (!here.ok()) Refuse(kSuggestPointFailed, {study_.study.file.string()});
    point.residuals = here.residuals;
    const Eigen::VectorXd x = variables_.FromValues(values_);
    const RefineOptions options;
    const std::optional<Eigen::MatrixXd> jacobian = DifferenceJacobian(
        archive, variables_, x, here.residuals, options.DifferenceStep(archive.problem()), Differences::kAutomatic);
    if (!jacobian) Refuse(kSuggestPointFailed, {study_.study.file.string()});
    point.jacobian = *jacobian;
    result_.evaluations += archive.counts().paid;
    const Eigen::VectorXd slope = FollowedCost(point).Slope();
    for (Index j = 0; j < x.size(); ++j)
      if (IsHeldByBound(x, j, slope[j])) point.jacobian.col(j).setZero();
    return FollowedCost(std::move(point));
  }

  /// Whether the cost would take the variable beyond its bound.
  bool IsHeldByBound(const Eigen::VectorXd& x, Index j, double slope) const {
    constexpr double kAtBound = 1e-6;
    const double near = kAtBound * (variables_.upper()[j] - variables_.lower()[j]);
    return (x[j] - variables_.lower()[j] < near && slope > 0) || (variables_.upper()[j] - x[j] < near && slope < 0);
  }

  std::vector<Trial> Trials() {
    std::vector<Addition> additions = AllAdditions(study_, objective_.AllParameters(values_));
    result_.tried = additions.size();
    std::vector<Trial> trials;
    trials.reserve(additions.size());
    for (Addition& addition : additions) trials.push_back({.addition = std::move(addition)});
    const bool integrates = !BalancesAlone();
    ++result_.evaluations;
    // One after the other: libraries that read vehicles report faults in one place.
    for (Trial& trial : trials) {
      hooks_.Show("suggest: reading " + std::to_string(&trial - trials.data() + 1) + " of " +
                  std::to_string(trials.size()) + " additions");
      if (hooks_.IsStopped()) break;
      try {
        trial.study = std::make_unique<AugmentedStudy>(study_, trial.addition, integrates);
      } catch (const FaultyInput& fault) {
        trial.failure = FirstErrorOf(fault.diagnostics());
      } catch (const SimulationError& error) {
        trial.failure = error.what();
      } catch (const std::invalid_argument& unfit) {
        trial.failure = unfit.what();
      }
    }
    return trials;
  }

  /// Whether the vehicle as it stands needs no integration: where an addition does, there is too much of it.
  bool BalancesAlone() const {
    const Addition none;
    return AugmentedStudy(study_, none, false).At(0, values_).has_value();
  }

  ResidualsOf Residuals(const Trial& trial) const {
    const Eigen::VectorXd x = variables_.FromValues(values_);
    return [this, &trial, x](double amount, const Eigen::VectorXd& step) -> std::optional<Eigen::VectorXd> {
      std::optional<Eigen::VectorXd> residuals = trial.study->At(amount, Moved(x, step));
      LeaveOutOtherCount(residuals);
      return residuals;
    };
  }

  /// A channel that is taken later ends earlier, and has fewer residuals to compare.
  void LeaveOutOtherCount(std::optional<Eigen::VectorXd>& residuals) const {
    if (residuals && residuals->size() != objective_.residual_count()) residuals.reset();
  }

  Eigen::VectorXd Moved(const Eigen::VectorXd& x, const Eigen::VectorXd& step) const {
    if (step.isZero(0)) return values_;
    return variables_.ToValues((x + step).cwiseMax(variables_.lower()).cwiseMin(variables_.upper()));
  }

  static AmountRange RangeOf(const Addition& addition) { return {addition.first, addition.least, addition.greatest}; }

  void TestAll(const FollowedCost& fitted, std::vector<Trial>& trials) {
    const double promise = LeastPromise(base_.cost, result_.residuals, result_.tried);
    LookAtAll(fitted, promise, trials);
    std::atomic<std::size_t> done = 0;
    std::atomic<std::int64_t> evaluations = 0;
    std::mutex shown;
    ForEachInParallel(trials.size(), threads_, [&](std::size_t i) {
      Trial& trial = trials[i];
      if (!trial.study || trial.test || hooks_.IsStopped()) return;
      trial.test = TestAmount(fitted, RangeOf(trial.addition), Residuals(trial), promise);
      if (trial.test) evaluations += trial.test->evaluations;
      else trial.failure = trial.study->failure();
      const std::size_t now = ++done;
      const std::lock_guard lock(shown);
      hooks_.Show("suggest: tested " + std::to_string(now) + " of " + std::to_string(trials.size()) + " additions");
    });
    result_.evaluations += evaluations;
    result_.is_interrupted = hooks_.IsStopped();
  }

  /// To first order: those that promise little, or less than many others, are done with.
  void LookAtAll(const FollowedCost& fitted, double promise, std::vector<Trial>& trials) {
    std::vector<Trial*> of_vehicle;
    std::vector<Trial*> of_study;
    for (Trial& trial : trials)
      if (trial.study) (trial.addition.study ? of_study : of_vehicle).push_back(&trial);
    LookAtVehicles(fitted, of_vehicle);
    LookAtStudies(fitted, of_study);
    std::vector<Trial*> seen = std::move(of_vehicle);
    seen.insert(seen.end(), of_study.begin(), of_study.end());
    std::erase_if(seen, [](const Trial* trial) { return !trial->test; });
    Sort(fitted, seen);
    std::set<std::string> promising;
    for (Trial* trial : seen) {
      if (base_.cost - trial->test->cost < promise) continue;
      const std::string key = trial->addition.Key();
      if (promising.size() == kEvaluated && !promising.contains(key)) continue;
      promising.insert(key);
      // It is worth evaluations.
      trial->test.reset();
    }
  }

  void LookAtVehicles(const FollowedCost& fitted, const std::vector<Trial*>& trials) {
    // Of so many one motion is followed; the same for any number of threads.
    constexpr std::size_t kTogether = 8;
    const std::size_t groups = (trials.size() + kTogether - 1) / kTogether;
    ForEachInParallel(groups, threads_, [&](std::size_t group) {
      if (hooks_.IsStopped()) return;
      const std::size_t first = group * kTogether;
      LookAt(fitted, std::span(trials).subspan(first, std::min(kTogether, trials.size() - first)));
    });
    result_.evaluations += static_cast<std::int64_t>(groups);
  }

  /// What a channel is off by changes residuals nearly in proportion.
  void LookAtStudies(const FollowedCost& fitted, const std::vector<Trial*>& trials) {
    ForEachInParallel(trials.size(), threads_, [&](std::size_t i) {
      if (hooks_.IsStopped()) return;
      Trial& trial = *trials[i];
      const auto there = Residuals(trial)(trial.addition.first, Eigen::VectorXd::Zero(values_.size()));
      if (there && there->allFinite()) trial.test = TestToFirstOrder(fitted, RangeOf(trial.addition), *there);
    });
    result_.evaluations += std::ssize(trials);
  }

  void LookAt(const FollowedCost& fitted, std::span<Trial* const> some) const {
    std::vector<FirstLook> looks;
    for (const Trial* trial : some) looks.push_back({trial->study.get(), trial->addition.first});
    const std::vector<std::optional<Eigen::VectorXd>> seen =
        fourpost::LookAt(objective_, values_, fitted.point().residuals, looks);
    for (std::size_t i = 0; i < some.size(); ++i)
      if (seen[i]) some[i]->test = TestToFirstOrder(fitted, RangeOf(some[i]->addition), *seen[i]);
  }

  double EffectiveOf(const FollowedCost& fitted, const Eigen::VectorXd& residuals) const {
    return EffectiveResiduals(fitted.Weighted(residuals).head(result_.residuals), structure_);
  }

  double CriterionOf(const FollowedCost& fitted, const Trial& trial) const {
    // By what is left with it: errors that it explains are alike because it is missing.
    const double effective = EffectiveOf(fitted, trial.test->left);
    return CriterionChange(base_.cost, trial.test->cost, result_.residuals, effective, trial.addition.count,
                           result_.tried, trial.addition.choices);
  }

  void Sort(const FollowedCost& fitted, std::vector<Trial*>& list) const {
    std::stable_sort(list.begin(), list.end(),
                     [&](const Trial* a, const Trial* b) { return CriterionOf(fitted, *a) < CriterionOf(fitted, *b); });
  }

  /// The best of those with the same words for each thing that could be added, by their criterion.
  std::vector<Trial*> Alternatives(const FollowedCost& fitted, std::vector<Trial>& trials) const {
    std::map<std::string, Trial*> of_words;
    for (Trial& trial : trials) {
      if (!trial.test) continue;
      Trial*& best = of_words.try_emplace(trial.addition.Key() + '|' + trial.addition.words, &trial).first->second;
      if (CriterionOf(fitted, trial) < CriterionOf(fitted, *best)) best = &trial;
    }
    std::vector<Trial*> list;
    for (const auto& [words, trial] : of_words) list.push_back(trial);
    Sort(fitted, list);
    return list;
  }

  /// The first things of the list, each with those of its alternatives that promise half as much at least, are
  /// evaluated truly: which of these is right is not seen to first order. Its other alternatives go; things of less
  /// promise stay as they are.
  void Confirm(const FollowedCost& fitted, std::vector<Trial*>& list) {
    constexpr double kNearly = 0.5;
    struct Thing {
      std::size_t rank = 0;
      double fall = 0;
    };
    std::map<std::string, Thing> things;
    std::vector<Trial*> first;
    std::vector<Trial*> others;
    for (Trial* trial : list) {
      const double fall = base_.cost - trial->test->cost;
      const auto [found, is_new] = things.try_emplace(trial->addition.Key(), Thing{things.size(), fall});
      const Thing& thing = found->second;
      if (thing.rank < kConfirmed && (is_new || fall > kNearly * thing.fall)) first.push_back(trial);
      else if (is_new) others.push_back(trial);
    }
    ConfirmEach(fitted, first);
    list = std::move(first);
    list.insert(list.end(), others.begin(), others.end());
    Sort(fitted, list);
  }

  void ConfirmEach(const FollowedCost& fitted, const std::vector<Trial*>& list) {
    std::vector<int> evaluated(list.size());
    ForEachInParallel(list.size(), threads_, [&](std::size_t i) {
      ScoreTest& test = *list[i]->test;
      const int earlier = test.evaluations;
      // Without any it promises nothing.
      if (earlier > 0 && !hooks_.IsStopped()) {
        fourpost::Confirm(fitted, RangeOf(list[i]->addition), Residuals(*list[i]), test);
        if (test.is_confirmed && list[i]->addition.parameters.size() > 1) FitNumbersOf(fitted, *list[i]);
      }
      evaluated[i] = test.evaluations - earlier;
    });
    for (const int number : evaluated) result_.evaluations += number;
  }

  /// What its amount ties together goes its own ways.
  void FitNumbersOf(const FollowedCost& fitted, Trial& trial) const {
    const FitVariables added = trial.study->AddedVariables();
    const Eigen::VectorXd x = variables_.FromValues(values_);
    const Eigen::VectorXd first = added.FromValues(trial.study->AddedAt(trial.test->amount));
    const auto residuals = [&](const Eigen::VectorXd& numbers, const Eigen::VectorXd& step) {
      std::optional<Eigen::VectorXd> there = trial.study->With(added.ToValues(numbers), Moved(x, step));
      LeaveOutOtherCount(there);
      return there;
    };
    const Eigen::VectorXd found = added.ToValues(FitNumbers(
        fitted, {.first = first, .lower = added.lower(), .upper = added.upper(), .residuals = residuals}, *trial.test));
    trial.values.assign(found.begin(), found.end());
  }

  /// The list runs from the best on.
  static void LeaveOutParts(std::vector<Trial*>& list) {
    std::vector<Trial*> kept;
    for (Trial* trial : list)
      if (std::none_of(kept.begin(), kept.end(),
                       [&](const Trial* better) { return trial->addition.IsPartOf(better->addition); }))
        kept.push_back(trial);
    list = std::move(kept);
  }

  SuggestedAddition Described(const FollowedCost& fitted, const Trial& trial) const {
    SuggestedAddition one{.addition = trial.addition, .amount = trial.test->amount};
    if (!trial.values.empty()) one.values = trial.values;
    else if (one.addition.values) one.values = one.addition.values(one.amount);
    one.others = trial.test->is_confirmed ? Moved(variables_.FromValues(values_), trial.test->step) : values_;
    one.cost = trial.test->cost;
    one.fall = 1 - trial.test->cost / base_.cost;
    one.criterion = CriterionOf(fitted, trial);
    one.effective = EffectiveOf(fitted, trial.test->left);
    one.moved = MovedBy(MoveOf(*trial.test));
    return one;
  }

  void Describe(const FollowedCost& fitted, const std::vector<Trial*>& list) {
    for (const Trial* trial : list) result_.list.push_back(Described(fitted, *trial));
    const std::size_t worthwhile = result_.Worthwhile();
    // What each changes in the residuals beyond what the variables could.
    std::vector<Eigen::VectorXd> beyond(worthwhile);
    for (std::size_t i = 0; i < worthwhile; ++i)
      beyond[i] = fitted.Weighted(fitted.Remainder(list[i]->test->alone - fitted.point().residuals));
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
    return test.step - base_.step;
  }

  /// Of those that were confirmed. Errors within the stated ones may well have a pattern: it cannot be held against the
  /// model, but parameters follow it.
  JoinedAdditions Joined(const FollowedCost& fitted, const std::vector<Trial*>& list) const {
    std::vector<OfferedAddition> offered;
    std::vector<std::size_t> confirmed;
    std::map<std::string, std::size_t> things;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (!list[i]->test->is_confirmed) continue;
      const std::size_t thing = things.try_emplace(list[i]->addition.Key(), things.size()).first->second;
      offered.push_back({fitted.Weighted(list[i]->test->left), thing});
      confirmed.push_back(i);
    }
    const auto change = [&](double before, const Eigen::VectorXd& left, std::size_t place) {
      // No number of residuals to compare the cost with: see CriterionChange().
      constexpr Index kNone = 0;
      const double effective = EffectiveResiduals(left.head(result_.residuals), structure_);
      const Addition& addition = list[confirmed[place]]->addition;
      return CriterionChange(before, left.squaredNorm(), kNone, effective, addition.count, result_.tried,
                             addition.choices);
    };
    JoinedAdditions joined = JoinAdditions(fitted.Weighted(base_.left), offered, change);
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

  void Join(const FollowedCost& fitted, const std::vector<Trial*>& list, const JoinedAdditions& joined,
            const std::vector<Trial*>& best) {
    if (result_.is_interrupted) return;
    result_.jacobian = fitted.point().jacobian;
    result_.left_together = base_.left;
    Eigen::MatrixXd moved(values_.size(), std::ssize(joined.places));
    for (Index k = 0; k < moved.cols(); ++k) {
      Trial* trial = list[joined.places[static_cast<std::size_t>(k)]];
      const auto place = static_cast<std::size_t>(std::find(best.begin(), best.end(), trial) - best.begin());
      result_.together.push_back(place);
      result_.list[place].worth = joined.worth[static_cast<std::size_t>(k)];
      result_.left_together += joined.shares[k] * (trial->test->left - base_.left);
      moved.col(k) = joined.shares[k] * MoveOf(*trial->test);
    }
    result_.moved_together = WithinBounds(moved);
    result_.moves_together = MovedBy(result_.moved_together.rowwise().sum());
  }

  /// Moves that add up to no more than the bounds let, as they limit what was evaluated.
  Eigen::MatrixXd WithinBounds(Eigen::MatrixXd moved) const {
    const Eigen::VectorXd x = variables_.FromValues(values_);
    for (Index j = 0; j < moved.rows(); ++j) {
      const double sum = moved.row(j).sum();
      const double to = std::clamp(x[j] + sum, variables_.lower()[j], variables_.upper()[j]) - x[j];
      if (to != sum) moved.row(j) *= to / sum;
    }
    return moved;
  }

  std::vector<MovedParameter> MovedBy(const Eigen::VectorXd& step) const {
    constexpr double kLeast = 0.01;
    const Eigen::VectorXd moved = Moved(variables_.FromValues(values_), step);
    std::vector<MovedParameter> list;
    for (Index j = 0; j < step.size(); ++j) {
      const Parameter& parameter = study_.vehicle.parameters[study_.free[static_cast<std::size_t>(j)]];
      const double whole = variables_.is_logarithmic(j) ? values_[j] : parameter.upper - parameter.lower;
      const double share = (moved[j] - values_[j]) / whole;
      if (std::abs(share) >= kLeast) list.push_back({parameter.name, share});
    }
    std::stable_sort(list.begin(), list.end(), [](const MovedParameter& a, const MovedParameter& b) {
      return std::abs(a.share) > std::abs(b.share);
    });
    return list;
  }

  const LoadedStudy& study_;
  const Eigen::VectorXd& values_;
  int threads_;
  const WorkHooks& hooks_;
  VehicleObjective objective_;
  FitVariables variables_;
  ResidualStructure structure_;
  /// Of the fitted point: it may lie beside the optimum, where noise of recorded inputs moved it.
  Followed base_;
  Suggestions result_;
};

}  // namespace

std::size_t Suggestions::Worthwhile() const {
  return static_cast<std::size_t>(
      std::count_if(list.begin(), list.end(), [](const SuggestedAddition& one) { return one.criterion < 0; }));
}

Suggestions SuggestFor(const LoadedStudy& study, const Eigen::VectorXd& values, int threads, const WorkHooks& hooks) {
  return Suggester(study, values, threads, hooks).Run();
}

}  // namespace fourpost
