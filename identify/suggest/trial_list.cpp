#include "identify/suggest/trial_list.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "identify/search/parallel.h"
#include "identify/suggest/addition_list.h"
#include "identify/suggest/aligned_residuals.h"
#include "identify/suggest/first_look.h"
#include "identify/suggest/new_numbers.h"
#include "vehicles/multibody/simulation_error.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Of how many things that could be added an amount is looked for by evaluations, and of how many additions all is
/// evaluated truly.
constexpr std::size_t kEvaluated = 24;
constexpr std::size_t kConfirmed = 12;

/// The list runs from the best on.
std::vector<Trial*> WithoutParts(const std::vector<Trial*>& list) {
  std::vector<Trial*> kept;
  for (Trial* trial : list)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const Trial* better) { return trial->addition.IsPartOf(better->addition); }))
      kept.push_back(trial);
  return kept;
}

/// Why the addition cannot be read; empty: it can.
std::string ReadInto(Trial& trial, const LoadedStudy& study, bool integrates,
                     const std::shared_ptr<KnownAnswers>& answers) {
  try {
    trial.study = std::make_unique<AugmentedStudy>(study, trial.addition, integrates, answers);
  } catch (const FaultyInput& fault) {
    return FirstErrorOf(fault.diagnostics());
  } catch (const SimulationError& error) {
    return error.what();
  } catch (const std::invalid_argument& unfit) {
    return unfit.what();
  }
  return "";
}

}  // namespace

TrialList::TrialList(const FittedStudy& study, int threads, const WorkHooks& hooks)
    : study_(study), threads_(threads), hooks_(hooks) {
  std::vector<Addition> additions = AllAdditions(study.study(), study.objective().AllParameters(study.values()));
  trials_.reserve(additions.size());
  for (Addition& addition : additions) trials_.push_back({.addition = std::move(addition)});
  Read();
}

/// One after the other: libraries that read vehicles report faults in one place.
void TrialList::Read() {
  const bool integrates = !BalancesAlone();
  const auto answers = std::make_shared<KnownAnswers>(study_.objective().AllParameters(study_.values()));
  ++evaluations_;
  for (Trial& trial : trials_) {
    hooks_.Show("suggest: reading " + std::to_string(&trial - trials_.data() + 1) + " of " +
                std::to_string(trials_.size()) + " additions");
    if (hooks_.IsStopped()) break;
    trial.failure = ReadInto(trial, study_.study(), integrates, answers);
  }
}

/// Whether the vehicle as it stands needs no integration: where an addition does, there is too much of it.
bool TrialList::BalancesAlone() const {
  const Addition none;
  return AugmentedStudy(study_.study(), none, false).At(0, study_.values()).has_value();
}

ResidualsOf TrialList::Residuals(const Trial& trial) const {
  return [this, &trial, x = study_.x()](double amount, const Eigen::VectorXd& step) -> std::optional<Eigen::VectorXd> {
    return Comparable(trial, trial.study->At(amount, study_.Moved(x, step)));
  };
}

/// A channel that is taken later ends earlier, and has fewer residuals to compare.
std::optional<Eigen::VectorXd> TrialList::Comparable(const Trial& trial,
                                                     std::optional<Eigen::VectorXd> residuals) const {
  if (!residuals || !trial.addition.study) return residuals;
  std::optional<Eigen::VectorXd> aligned =
      AlignedTo({study_.fitted().point().residuals, study_.structure()}, {*residuals, trial.study->structure()});
  if (!aligned) trial.study->Fail("its residuals are not those of the study, and cannot be compared with them");
  return aligned;
}

void TrialList::Test() {
  const double promise = LeastPromise(study_.base().cost, study_.measured_count(), trials_.size());
  LookAtAll(promise);
  EvaluateThePromising(promise);
}

/// Of those that have no test yet the amount is looked for.
void TrialList::EvaluateThePromising(double promise) {
  std::atomic<std::size_t> done = 0;
  std::atomic<std::int64_t> evaluations = 0;
  std::mutex shown;
  ForEachInParallel(trials_.size(), threads_, [&](std::size_t i) {
    Trial& trial = trials_[i];
    if (!trial.study || trial.test || hooks_.IsStopped()) return;
    trial.test = TestAmount(study_.fitted(), trial.range(), Residuals(trial), promise);
    if (trial.test) evaluations += trial.test->evaluations;
    else trial.failure = trial.study->failure();
    const std::size_t now = ++done;
    const std::lock_guard lock(shown);
    hooks_.Show("suggest: tested " + std::to_string(now) + " of " + std::to_string(trials_.size()) + " additions");
  });
  evaluations_ += evaluations;
}

/// To first order: those that promise little, or less than many others, are done with.
void TrialList::LookAtAll(double promise) {
  std::vector<Trial*> of_vehicle;
  std::vector<Trial*> of_study;
  for (Trial& trial : trials_)
    if (trial.study) (trial.addition.study ? of_study : of_vehicle).push_back(&trial);
  LookAtVehicles(of_vehicle);
  LookAtStudies(of_study);
  std::vector<Trial*> seen = std::move(of_vehicle);
  seen.insert(seen.end(), of_study.begin(), of_study.end());
  std::erase_if(seen, [](const Trial* trial) { return !trial->test; });
  Sort(seen);
  std::set<std::string> promising;
  for (Trial* trial : seen) {
    if (study_.base().cost - trial->test->cost < promise) continue;
    const std::string key = trial->addition.Key();
    if (promising.size() == kEvaluated && !promising.contains(key)) continue;
    promising.insert(key);
    // It is worth evaluations.
    trial->test.reset();
  }
}

void TrialList::LookAtVehicles(const std::vector<Trial*>& trials) {
  // Of so many one motion is followed; the same for any number of threads.
  constexpr std::size_t kTogether = 8;
  const std::size_t groups = (trials.size() + kTogether - 1) / kTogether;
  ForEachInParallel(groups, threads_, [&](std::size_t group) {
    if (hooks_.IsStopped()) return;
    const std::size_t first = group * kTogether;
    LookAtSome(std::span(trials).subspan(first, std::min(kTogether, trials.size() - first)));
  });
  evaluations_ += static_cast<std::int64_t>(groups);
}

/// What a channel is off by changes residuals nearly in proportion.
void TrialList::LookAtStudies(const std::vector<Trial*>& trials) {
  ForEachInParallel(trials.size(), threads_, [&](std::size_t i) {
    if (hooks_.IsStopped()) return;
    Trial& trial = *trials[i];
    const auto there = Residuals(trial)(trial.addition.first, Eigen::VectorXd::Zero(study_.values().size()));
    if (there && there->allFinite()) trial.test = TestToFirstOrder(study_.fitted(), trial.range(), *there);
  });
  evaluations_ += std::ssize(trials);
}

void TrialList::LookAtSome(std::span<Trial* const> some) const {
  std::vector<FirstLook> looks;
  for (const Trial* trial : some) looks.push_back({trial->study.get(), trial->addition.first});
  const std::vector<std::optional<Eigen::VectorXd>> seen =
      LookAt(study_.objective(), study_.values(), study_.fitted().point().residuals, looks);
  for (std::size_t i = 0; i < some.size(); ++i)
    if (seen[i]) some[i]->test = TestToFirstOrder(study_.fitted(), some[i]->range(), *seen[i]);
}

double TrialList::CriterionOf(const Trial& trial) const {
  return study_.CriterionOf(trial.addition, *trial.test, trials_.size());
}

void TrialList::Sort(std::vector<Trial*>& list) const {
  std::map<const Trial*, double> criteria;
  for (const Trial* trial : list) criteria[trial] = CriterionOf(*trial);
  std::stable_sort(list.begin(), list.end(), [&](const Trial* a, const Trial* b) { return criteria[a] < criteria[b]; });
}

std::vector<Trial*> TrialList::Best() {
  std::vector<Trial*> list = Alternatives();
  Confirm(list);
  std::erase_if(list, [&](const Trial* trial) { return trial->IsImitation(study_.base().cost); });
  return WithoutParts(list);
}

std::vector<Trial*> TrialList::Alternatives() {
  std::map<std::string, Trial*> of_words;
  for (Trial& trial : trials_) {
    if (!trial.test) continue;
    Trial*& best = of_words.try_emplace(trial.addition.Key() + '|' + trial.addition.words, &trial).first->second;
    if (CriterionOf(trial) < CriterionOf(*best)) best = &trial;
  }
  std::vector<Trial*> list;
  for (const auto& [words, trial] : of_words) list.push_back(trial);
  Sort(list);
  return list;
}

/// The first things of the list, each with those of its alternatives that promise half as much at least, are
/// evaluated truly: which of these is right is not seen to first order. Its other alternatives go; things of less
/// promise stay as they are.
void TrialList::Confirm(std::vector<Trial*>& list) {
  constexpr double kNearly = 0.5;
  struct Thing {
    std::size_t rank = 0;
    double fall = 0;
  };
  std::map<std::string, Thing> things;
  std::vector<Trial*> first;
  std::vector<Trial*> others;
  for (Trial* trial : list) {
    const double fall = study_.base().cost - trial->test->cost;
    const auto [found, is_new] = things.try_emplace(trial->addition.Key(), Thing{things.size(), fall});
    const Thing& thing = found->second;
    if (thing.rank < kConfirmed && (is_new || fall > kNearly * thing.fall)) first.push_back(trial);
    else if (is_new) others.push_back(trial);
  }
  ConfirmEach(first);
  list = std::move(first);
  list.insert(list.end(), others.begin(), others.end());
  Sort(list);
}

void TrialList::ConfirmEach(const std::vector<Trial*>& list) {
  std::vector<int> evaluated(list.size());
  ForEachInParallel(list.size(), threads_, [&](std::size_t i) {
    ScoreTest& test = *list[i]->test;
    const int earlier = test.evaluations;
    // Without any it promises nothing.
    if (earlier > 0 && !hooks_.IsStopped()) {
      fourpost::Confirm(study_.fitted(), list[i]->range(), Residuals(*list[i]), test);
      if (test.is_confirmed && list[i]->addition.parameters.size() > 1) FitNumbersOf(*list[i]);
    }
    evaluated[i] = test.evaluations - earlier;
  });
  for (const int number : evaluated) evaluations_ += number;
}

/// What its amount ties together goes its own ways.
void TrialList::FitNumbersOf(Trial& trial) const {
  const FitVariables added = trial.study->AddedVariables();
  const Eigen::VectorXd first = added.FromValues(trial.study->AddedAt(trial.test->amount));
  const auto residuals = [&, x = study_.x()](const Eigen::VectorXd& numbers, const Eigen::VectorXd& step) {
    return trial.study->With(added.ToValues(numbers), study_.Moved(x, step));
  };
  const NewNumbers numbers{.first = first, .lower = added.lower(), .upper = added.upper(), .residuals = residuals};
  const Eigen::VectorXd found = added.ToValues(FitNumbers(study_.fitted(), numbers, *trial.test));
  trial.values.assign(found.begin(), found.end());
}

}  // namespace fourpost
