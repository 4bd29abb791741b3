#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/process/work_hooks.h"
#include "identify/suggest/fitted_study.h"
#include "identify/suggest/trial.h"

namespace fourpost {

/// All additions to a fitted study, tested: most to first order, those that promise much by evaluations.
class TrialList {
 public:
  TrialList(const FittedStudy& study, int threads, const WorkHooks& hooks);

  void Test();
  /// The best of those with the same words for each thing that could be added, by their criterion; those that promise
  /// most are evaluated truly. Parts of a better one and imitations are left out.
  std::vector<Trial*> Best();

  const std::vector<Trial>& all() const { return trials_; }
  double CriterionOf(const Trial& trial) const;
  std::int64_t evaluations() const { return evaluations_; }

 private:
  void Read();
  bool BalancesAlone() const;
  ResidualsOf Residuals(const Trial& trial) const;
  std::optional<Eigen::VectorXd> Comparable(const Trial& trial, std::optional<Eigen::VectorXd> residuals) const;
  void LookAtAll(double promise);
  void LookAtVehicles(const std::vector<Trial*>& trials);
  void LookAtStudies(const std::vector<Trial*>& trials);
  void LookAtSome(std::span<Trial* const> some) const;
  void EvaluateThePromising(double promise);
  void Sort(std::vector<Trial*>& list) const;
  std::vector<Trial*> Alternatives();
  void Confirm(std::vector<Trial*>& list);
  void ConfirmEach(const std::vector<Trial*>& list);
  void FitNumbersOf(Trial& trial) const;

  const FittedStudy& study_;
  int threads_;
  const WorkHooks& hooks_;
  std::vector<Trial> trials_;
  std::int64_t evaluations_ = 0;
};

}  // namespace fourpost
