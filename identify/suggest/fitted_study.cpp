#include "identify/suggest/fitted_study.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "identify/refine/difference_jacobian.h"
#include "identify/refine/refine.h"
#include "identify/search/archive.h"
#include "identify/suggest/findings.h"

namespace fourpost {

using Eigen::Index;

FittedStudy::FittedStudy(const LoadedStudy& study, const Eigen::VectorXd& values, int threads)
    : study_(study),
      values_(values),
      objective_(study.MakeObjective()),
      variables_(objective_.MakeProblem().lattice),
      structure_(JoinedStructure(objective_.blocks())),
      fitted_(Fitted(threads)),
      base_(fitted_.Of(fitted_.point().residuals)) {}

FollowedCost FittedStudy::Fitted(int threads) {
  Archive archive(objective_.MakeProblem(), threads);
  const LossKind kind = study_.study.refine.loss;
  FittedPoint point;
  point.loss = RobustLoss(kind, study_.study.refine.scale.value_or(UsualScale(kind)), objective_.prior_count());
  const Evaluation here = archive.EvaluateValues({values_}).front();
  if (!here.ok()) Refuse(kSuggestPointFailed, {study_.study.file.string()});
  point.residuals = here.residuals;
  const RefineOptions options;
  const std::optional<Eigen::MatrixXd> jacobian = DifferenceJacobian(
      archive, variables_, x(), here.residuals, options.DifferenceStep(archive.problem()), Differences::kAutomatic);
  if (!jacobian) Refuse(kSuggestPointFailed, {study_.study.file.string()});
  point.jacobian = *jacobian;
  evaluations_ = archive.counts().paid;
  const Eigen::VectorXd slope = FollowedCost(point).Slope();
  for (Index j = 0; j < values_.size(); ++j)
    if (IsHeldByBound(x(), j, slope[j])) point.jacobian.col(j).setZero();
  return FollowedCost(std::move(point));
}

/// Whether the cost would take the variable beyond its bound.
bool FittedStudy::IsHeldByBound(const Eigen::VectorXd& x, Index j, double slope) const {
  constexpr double kAtBound = 1e-6;
  const double near = kAtBound * (variables_.upper()[j] - variables_.lower()[j]);
  return (x[j] - variables_.lower()[j] < near && slope > 0) || (variables_.upper()[j] - x[j] < near && slope < 0);
}

Eigen::VectorXd FittedStudy::Moved(const Eigen::VectorXd& x, const Eigen::VectorXd& step) const {
  if (step.isZero(0)) return values_;
  return variables_.ToValues((x + step).cwiseMax(variables_.lower()).cwiseMin(variables_.upper()));
}

double FittedStudy::Effective(const Eigen::VectorXd& residuals) const {
  return EffectiveOfWeighted(fitted_.Weighted(residuals));
}

double FittedStudy::EffectiveOfWeighted(const Eigen::VectorXd& residuals) const {
  return EffectiveResiduals(residuals.head(data_count()), structure_);
}

double FittedStudy::CriterionOf(const Addition& addition, const ScoreTest& test, std::size_t tried) const {
  // By what is left with it: errors that it explains are alike because it is missing.
  return CriterionChange(base_.cost, test.cost, measured_count(), Effective(test.left), addition.count, tried,
                         addition.choices);
}

}  // namespace fourpost
