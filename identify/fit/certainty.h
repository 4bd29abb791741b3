#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/refine/refine.h"
#include "identify/residuals/vehicle_objective.h"
#include "identify/search/archive.h"
#include "identify/uncertainty/covariance.h"
#include "identify/uncertainty/model_error_estimate.h"
#include "identify/uncertainty/parameter_state.h"

namespace fourpost {

/// Parameters that a fit holds although their ranges say that they are not exactly known.
struct HeldParameters {
  /// Places in Vehicle::parameters.
  std::vector<std::size_t> places;
  /// In FitVariables: of the prior, else of the range, uniform over it.
  Eigen::VectorXd variable_sd;
  /// d residuals / d FitVariables of them, N x held; priors of the free ones included.
  Eigen::MatrixXd jacobian;
};

/// What data and priors say at an optimum, and of which parameters they cannot say anything there. Vectors have one
/// entry per free parameter; deviations are those of FitVariables, NaN and infinite as in Covariance.
struct Certainty {
  /// Of noise alone.
  Covariance covariance;
  std::vector<ParameterState> states;
  /// Of noise, of what is held, and of what the model lacks, which is zero where noise explains all disagreement.
  Eigen::VectorXd noise_sd;
  Eigen::VectorXd held_sd;
  Eigen::VectorXd model_sd;
  /// Of all of them; `covariance.reach_95` times this is half an interval.
  Eigen::VectorXd total_sd;
  /// Judged parameters only.
  ModelErrorEstimate model_error;
  /// Those as places among the free ones.
  std::vector<Eigen::Index> judged;
  /// In FitVariables, judged x judged: of noise alone, and of all parts.
  Eigen::MatrixXd noise_covariance;
  Eigen::MatrixXd total_covariance;
  /// Names of held parameters, and the deviation that each adds, held x free.
  std::vector<std::string> held;
  Eigen::MatrixXd by_held;

  /// What most of a parameter's deviation comes from: "noise"; "model: " and the part of the data that pulls it most;
  /// "held: " and the parameter that moves it most. Empty for one without a deviation.
  std::string LimitedBy(Eigen::Index parameter) const;

  /// Recordings without which a parameter would leave its interval by noise, beyond what noise lets it move; with
  /// places among the free parameters.
  std::vector<Contradiction> Contradictions() const;
};

/// Of the parameters that are not free but have a range, at these values of the free ones; adds evaluations to
/// `evaluated`. Those whose derivative cannot be evaluated are left out.
HeldParameters HeldAt(const VehicleObjective& objective, const Eigen::VectorXd& values, const RefineOptions& refine,
                      int threads, const std::function<bool()>& stop, std::int64_t& evaluated);

/// Of parameters that cannot have a deviation at this optimum. `noisy`: places of those whose derivatives are noise. A
/// parameter at its bound that changes nothing is not held there by the bound.
std::vector<ParameterState> StatesAt(const RefineResult& best, const Lattice& lattice,
                                     const std::vector<Eigen::Index>& noisy);
/// Places of those that are not kDetermined.
std::vector<Eigen::Index> FixedOf(const std::vector<ParameterState>& states);

/// `states`: see StatesAt(). `input_noise`: N x n, what noise of the inputs adds to the gradient; empty: nothing.
Certainty CertaintyAt(const VehicleObjective& objective, const Lattice& lattice, const RefineResult& best,
                      const RobustLoss& loss, const std::vector<ParameterState>& states,
                      const Eigen::MatrixXd& input_noise, const HeldParameters& held);

/// Whether a value is at a bound of its range: refinement stops at steps of 1e-8.
bool IsAtBound(const LatticeAxis& axis, double value);

}  // namespace fourpost
