#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/fit/optimum.h"
#include "identify/refine/refine.h"
#include "identify/residuals/vehicle_objective.h"
#include "identify/search/archive.h"
#include "identify/uncertainty/covariance.h"
#include "identify/uncertainty/model_error_estimate.h"
#include "identify/uncertainty/parameter_state.h"

namespace fourpost {

struct InputNoise;

/// What the data say of an instrument that is known to a standard deviation.
struct CalibrationEstimate {
  /// "gain of accelerometers", and the unit of the numbers: a share, "s" or "N".
  std::string name;
  std::string unit;
  /// As stated.
  double sd = 0;
  /// What data and statement together say, and how well; the statement alone says 0.
  double estimate = 0;
  double estimate_sd = 0;
  /// How far the data alone are from the statement, over the standard deviation of both.
  double surprise = 0;
};

/// By chance in one of eighty instruments.
inline bool IsSurprising(const CalibrationEstimate& estimate) { return std::abs(estimate.surprise) > 2.5; }

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
  /// Names of held parameters and, after them, of calibrations, and the deviation that each adds, held x free.
  std::vector<std::string> held;
  Eigen::MatrixXd by_held;
  /// Names of held parameters that no deviation allows for.
  std::vector<std::string> held_left_out;
  std::vector<CalibrationEstimate> calibrations;
  /// In words, what the model lacks by its own residuals, and by what each would move the free parameters, n x
  /// additions in FitVariables; empty: nothing is known of that.
  std::vector<std::string> missing;
  Eigen::MatrixXd by_missing;

  /// Changes `model_sd` to that of a parameter which lies anywhere between its value and where it would be with all of
  /// `names` added, and of parts of the data that contradict each other as before or, with even odds, as in `left`, see
  /// ModelErrorLeft(). `moved`: see `by_missing`.
  void AllowForMissing(std::vector<std::string> names, Eigen::MatrixXd moved, const ModelErrorEstimate& left);
  /// Whether intervals allow for more than noise and what is held.
  bool IsBeyondNoise() const { return model_error.is_significant || !missing.empty(); }
  /// In how many cases intervals hold the truth: "95 %", "80 to 90 %".
  std::string Confidence() const { return IsBeyondNoise() ? "80 to 90 %" : "95 %"; }
  /// By all that is missing, n; zero where nothing is known.
  Eigen::VectorXd MovedByMissing() const;
  /// `total_sd` about the value, or about where the parameter would be with what is missing.
  double SdAboutEnds(Eigen::Index parameter) const;
  /// Of the interval before bounds cut it.
  double HalfWidth(Eigen::Index parameter) const;

  /// What most of a parameter's deviation comes from: "noise"; "model: " and the part of the data that pulls it most;
  /// "held: " and the parameter, or "calibration: " and the instrument, that moves it most. Empty for one without a
  /// deviation.
  std::string LimitedBy(Eigen::Index parameter) const;

  /// Recordings without which a parameter would leave its interval by noise, beyond what noise lets it move; with
  /// places among the free parameters.
  std::vector<Contradiction> Contradictions() const;
};

/// Nothing where no calibration is stated or the model cannot be evaluated. `states`: see CertaintyAt(); `noise`: empty
/// matrices: none.
std::optional<Calibrated> CalibratedAt(const VehicleObjective& objective, const Lattice& lattice,
                                       const RefineResult& best, const RobustLoss& loss,
                                       const std::vector<ParameterState>& states, const InputNoise& noise);

/// Of parameters that cannot have a deviation at this optimum. `noisy`: places of those whose derivatives are noise. A
/// parameter at its bound that changes nothing is not held there by the bound.
std::vector<ParameterState> StatesAt(const RefineResult& best, const Lattice& lattice,
                                     const std::vector<Eigen::Index>& noisy);
/// Places of those that are not kDetermined.
std::vector<Eigen::Index> FixedOf(const std::vector<ParameterState>& states);

/// `states`: see StatesAt(). `input_noise`: N x n, what noise of the inputs adds to the gradient; empty: nothing.
/// `calibrated`: nothing, or what the residuals of `best` have been corrected by.
Certainty CertaintyAt(const VehicleObjective& objective, const Lattice& lattice, const RefineResult& best,
                      const RobustLoss& loss, const std::vector<ParameterState>& states,
                      const Eigen::MatrixXd& input_noise, const HeldParameters& held,
                      const std::optional<Calibrated>& calibrated = {});

/// What parts of the data still contradict each other in once what the model lacks is taken from its residuals.
/// `explained`: the residuals that are then left, priors included, with the values and the derivatives of the fit.
ModelErrorEstimate ModelErrorLeft(const VehicleObjective& objective, const Lattice& lattice,
                                  const RefineResult& explained, const RobustLoss& loss,
                                  const std::vector<Eigen::Index>& judged);

/// Whether a value is at a bound of its range: refinement stops at steps of 1e-8.
bool IsAtBound(const LatticeAxis& axis, double value);

}  // namespace fourpost
