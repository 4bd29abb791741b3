#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/experiments/known_answers.h"
#include "identify/refine/fit_variables.h"
#include "identify/residuals/residual_structure.h"
#include "identify/residuals/vehicle_objective.h"
#include "identify/study/loaded_study.h"
#include "identify/suggest/addition.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// The first error's message; empty without one.
std::string FirstErrorOf(const Diagnostics& diagnostics);

/// The vehicle of an addition's text with the values that the study gives its parameters, by `start` or an option.
Vehicle WithValuesOf(const Vehicle& studied, Vehicle extended);

/// A study's objective with one addition in it. Both must outlive it.
class AugmentedStudy {
 public:
  /// `integrates`: see Subject. `answers`: of the study's vehicle, for additions to the study. Throws FaultyInput where
  /// the vehicle cannot be read, assembled or held.
  AugmentedStudy(const LoadedStudy& study, const Addition& addition, bool integrates,
                 std::shared_ptr<KnownAnswers> answers = nullptr);

  /// Residuals; nothing where they cannot be evaluated. `values`: of the study's free parameters. Not from several
  /// threads at once.
  std::optional<Eigen::VectorXd> At(double amount, const Eigen::VectorXd& values) const;

  /// Of an addition to the vehicle: that vehicle, at an amount; nothing of what is added to the study.
  std::optional<OtherVehicle> VehicleAt(double amount, const Eigen::VectorXd& values) const;
  /// Of an addition to the vehicle.
  const VehicleObjective& objective() const { return *objective_; }
  /// Of an evaluation.
  double deadline_s() const { return study_.study.search.deadline_s; }

  /// The same for values of the addition's parameters in place of an amount.
  std::optional<Eigen::VectorXd> With(const Eigen::VectorXd& added, const Eigen::VectorXd& values) const;

  /// Of the addition's parameters.
  FitVariables AddedVariables() const;
  /// Their values at an amount, within their bounds.
  Eigen::VectorXd AddedAt(double amount) const;

  /// Of an addition to the study: how the residuals of the last evaluation belong together.
  const ResidualStructure& structure() const { return structure_; }

  /// Why the last evaluation that failed did.
  const std::string& failure() const { return failure_; }
  /// What was evaluated cannot be used.
  void Fail(const std::string& why) const { failure_ = why; }

 private:
  std::vector<LatticeAxis> AddedAxes() const;
  std::size_t PlaceOf(const std::string& name) const;
  /// Values of the addition's parameters.
  Eigen::VectorXd Added(double amount) const;
  /// Of all free parameters, the addition's behind those of the study.
  static Eigen::VectorXd Extended(const Eigen::VectorXd& added, const Eigen::VectorXd& values);
  std::optional<Eigen::VectorXd> Evaluated(const VehicleObjective& objective, const Eigen::VectorXd& values) const;
  std::optional<Eigen::VectorXd> OfStudy(double amount, const Eigen::VectorXd& values) const;

  const LoadedStudy& study_;
  const Addition& addition_;
  Vehicle vehicle_;
  std::vector<std::size_t> free_;
  std::shared_ptr<KnownAnswers> answers_;
  std::shared_ptr<const CondensedVehicle> condensed_;
  std::optional<VehicleObjective> objective_;
  mutable ResidualStructure structure_;
  mutable std::string failure_;
};

}  // namespace fourpost
