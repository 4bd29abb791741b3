#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "identify/refine/fit_variables.h"
#include "identify/residuals/residual_structure.h"
#include "identify/residuals/vehicle_objective.h"
#include "identify/study/loaded_study.h"
#include "identify/suggest/addition.h"
#include "identify/suggest/score_test.h"

namespace fourpost {

/// A study at the values of its fit, about which additions are judged.
class FittedStudy {
 public:
  /// `study`: as of SuggestFor(). It must outlive this. Throws FaultyInput where the values cannot be evaluated.
  FittedStudy(const LoadedStudy& study, const Eigen::VectorXd& values, int threads);

  const LoadedStudy& study() const { return study_; }
  const VehicleObjective& objective() const { return objective_; }
  const FitVariables& variables() const { return variables_; }
  const FollowedCost& fitted() const { return fitted_; }
  /// Of the fitted point: it may lie beside the optimum, where noise of recorded inputs moved it.
  const Followed& base() const { return base_; }
  /// SI, of the free parameters.
  const Eigen::VectorXd& values() const { return values_; }
  /// In FitVariables.
  Eigen::VectorXd x() const { return variables_.FromValues(values_); }
  /// Values with a step of FitVariables, within the bounds.
  Eigen::VectorXd Moved(const Eigen::VectorXd& x, const Eigen::VectorXd& step) const;

  const ResidualStructure& structure() const { return structure_; }
  /// Residuals of the data, and how many independent ones these or others are worth.
  Eigen::Index data_count() const { return fitted_.point().residuals.size() - objective_.prior_count(); }
  /// Those of samples that were measured.
  Eigen::Index measured_count() const { return data_count() - objective_.unmeasured_count(); }
  double Effective(const Eigen::VectorXd& residuals) const;
  /// The same of residuals that have their weights.
  double EffectiveOfWeighted(const Eigen::VectorXd& residuals) const;
  /// See CriterionChange(); of an addition among `tried`.
  double CriterionOf(const Addition& addition, const ScoreTest& test, std::size_t tried) const;
  std::int64_t evaluations() const { return evaluations_; }

 private:
  FollowedCost Fitted(int threads);
  bool IsHeldByBound(const Eigen::VectorXd& x, Eigen::Index j, double slope) const;

  const LoadedStudy& study_;
  Eigen::VectorXd values_;
  VehicleObjective objective_;
  FitVariables variables_;
  ResidualStructure structure_;
  std::int64_t evaluations_ = 0;
  FollowedCost fitted_;
  Followed base_;
};

}  // namespace fourpost
