#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/process/deadline.h"
#include "identify/experiments/time_history/history_data.h"
#include "identify/experiments/time_history/history_simulation.h"
#include "identify/experiments/time_history/kalman_predictor.h"
#include "identify/experiments/time_history/post_noise.h"
#include "identify/residuals/residual_block.h"
#include "identify/study_file/calibration.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {

/// How far a vehicle is from histories, as residuals. Whitened:
///   (modelled - measured) / sqrt(noise^2 + (model error s)^2) at every MeasuredHistory::Stride-th sample,
/// s: the signal's own deviation, at least 2 % of that of the loudest of its unit; no noise is white behind a filter at
/// the full rate. By compromise (thesis 4.29):
///   J_k r_k / |r_k|, J_k = |r_k|^2 the signal's normalised mean square error [%],
/// whose squares add up to the sum of all J_k^2, with weights 1 and aims 0. By prediction: of the innovations e of a
/// KalmanPredictor with covariances S
///   S^-1/2 e exp((D - D_0) / 2N),  D = sum of ln det S, D_0 that of the file's values, N residuals.
/// With C the sum of their squares, minus twice the log likelihood is N ln C + const once the common scale of all noise
/// has its likeliest value, C / N: so they are least where the innovations are likeliest. Without the determinant they
/// would be least where S is large. Ratios of the noise are held at those under which the file's values are likeliest.
/// Immutable; serves any number of threads.
class HistoryResiduals {
 public:
  struct Options {
    HistoryCost cost = HistoryCost::kWhitened;
    /// What the model leaves out, as a share of each signal's deviation.
    double model_error = 0.02;
    /// Of the integration, of each channel's rms; the error left is about a third of it, a ten-thousandth of a per cent
    /// of a mean square.
    double error = 3e-3;
    /// Of the integration, one per history; empty: those that the vehicle needs at its file's values.
    std::vector<double> steps_s = {};
    /// Of a cost by prediction, one per history; empty: estimated at the file's values.
    std::vector<KalmanNoise> noise = {};
    /// Of the estimate's runs.
    NoiseSearch noise_search = {};
  };

  /// Throws FaultyInput as CondensedVehicle does, and as KalmanPredictor does.
  HistoryResiduals(std::shared_ptr<const CondensedVehicle> vehicle, std::vector<MeasuredHistory> histories,
                   const Options& options);

  /// Simulations refer to the histories.
  HistoryResiduals(const HistoryResiduals&) = delete;
  HistoryResiduals& operator=(const HistoryResiduals&) = delete;
  HistoryResiduals(HistoryResiduals&&) = default;

  Eigen::Index count() const { return count_; }

  /// `values`: all parameters of the vehicle, SI. Throws TimedOut, and std::runtime_error where the motion cannot be
  /// computed.
  Eigen::VectorXd At(const std::vector<double>& values, const Deadline& deadline = {}) const;

  /// Whether Derivatives() are to be had: neither of a cost by prediction nor of a release, whose start is estimated.
  bool HasDerivatives() const;
  /// d residuals / d parameter per SI unit, count x `parameters` (indices): of the integration as it is, see
  /// MotionSensitivity; of elements that have a memory by differences. Throws std::runtime_error where the motion
  /// cannot be computed.
  Eigen::MatrixXd Derivatives(const std::vector<double>& values, const std::vector<std::size_t>& parameters) const;
  /// See ResidualBlock::toward; where there are derivatives. Throws as they do.
  Eigen::MatrixXd Toward(const std::vector<double>& values, std::span<const OtherVehicle> others) const;

  /// Per history, samples of the window x signals; whitened, with the state at the start that suits it, see AddStart().
  std::vector<Eigen::MatrixXd> Modelled(const std::vector<double>& values) const;

  /// Whitened: the same residuals with a quarter of each history's step. Throws std::runtime_error where the motion
  /// cannot be computed.
  Eigen::VectorXd AtFinerSteps(const std::vector<double>& values) const;

  /// Of a cost by prediction; of each history.
  std::vector<KalmanPrediction> Predicted(const std::vector<double>& values, const Deadline& deadline = {}) const;
  const std::vector<KalmanNoise>& noise() const { return noise_; }

  const std::vector<MeasuredHistory>& histories() const { return histories_; }
  /// Of each history [s].
  std::vector<double> Steps() const;

  /// Whitened: of each history. Throws as PostNoiseOf() does.
  std::vector<PostNoise> PostNoiseAt(const std::vector<double>& values) const;
  /// Whitened: of each history the rms of what that noise adds to the residuals of each signal. Throws as that does.
  std::vector<Eigen::VectorXd> ByPostNoise(const std::vector<double>& values) const;

  /// By how much half the step changes each history at these values: of its signals the largest rms of the change, as a
  /// share of the signal's own. Steps are those of the file's values, and others may want finer ones.
  std::vector<double> ChangesByHalfStep(const std::vector<double>& values) const;

  const Options& options() const { return options_; }

  /// Whitened: what one standard deviation of each calibration would change, count x calibrations. Throws
  /// std::runtime_error where the motion cannot be computed.
  Eigen::MatrixXd ByCalibrations(const std::vector<Calibration>& calibrations, const std::vector<double>& values) const;

  /// Groups of sensors, recordings, and the order of samples.
  ResidualStructure Structure() const;

  /// Of a whitened residual.
  double DeviationOf(const MeasuredSignal& signal) const;

  /// Whitened: what an engine gives from rest, with what another state at the record's first sample changes in the
  /// reduced model: that which suits the measurement best, if it takes away a tenth of the squares of what was missed,
  /// which errors of a model do not come to from rest. Found by Gauss and Newton's method with the free motion of
  /// AddStart(), so that dampers may be nonlinear; of hydraulic ones to first order.
  Eigen::MatrixXd WithStart(std::size_t history, const std::vector<double>& values,
                            const Eigen::MatrixXd& modelled) const;

  /// The vehicle at these values, and at the history's setting.
  CondensedModel ModelOf(const MeasuredHistory& history, const std::vector<double>& values) const;

 private:
  /// What AddStartTo() adds is a sum of these, residuals x columns, at the file's values.
  Eigen::MatrixXd Starts() const;
  /// Residuals of a signal.
  Eigen::Index CountOf(const MeasuredHistory& history) const;
  Eigen::MatrixXd Modelled(std::size_t h, const CondensedModel& model, const Deadline& deadline) const;
  /// What becomes of models that Covers() refuses: NaN, or their own integration.
  enum class Uncovered { kLeftOut, kIntegrated };
  /// Residuals with each of `count` models less those at these values, in columns; to first order where it can be.
  Eigen::MatrixXd Changes(const std::vector<double>& values, std::size_t count,
                          const std::function<CondensedModel(std::size_t, const MeasuredHistory&)>& model_of,
                          Uncovered uncovered) const;
  /// The same values with a small difference of one parameter.
  std::vector<double> NeighbourOf(std::vector<double> values, std::size_t parameter) const;
  /// Of one history.
  Eigen::VectorXd ResidualsOf(const MeasuredHistory& history, const CondensedModel& model,
                              Eigen::MatrixXd modelled) const;
  void AddHistory(const MeasuredHistory& history, const Eigen::MatrixXd& modelled, Eigen::Index& at,
                  Eigen::VectorXd& out) const;
  /// What the signals would be with an instrument off by one standard deviation, the state at the start not added.
  Eigen::MatrixXd Calibrated(std::size_t h, const CondensedModel& model, const Calibration& calibration,
                             const Eigen::MatrixXd& modelled) const;
  /// See WithStart(). Throws as HistorySimulation::Run() does.
  Eigen::MatrixXd MarchedFrom(std::size_t h, const CondensedModel& model, const Eigen::MatrixXd& modelled) const;
  /// Of each signal's squares.
  Eigen::VectorXd WeightsOf(const MeasuredHistory& history) const;
  /// Weighted, of every sample that counts.
  double SquaresOf(const MeasuredHistory& history, const Eigen::MatrixXd& modelled) const;
  /// The state at the start that suits it added.
  void AddStartTo(const MeasuredHistory& history, const CondensedModel& model, Eigen::MatrixXd& modelled) const;
  Eigen::VectorXd OfPrediction(const std::vector<KalmanPrediction>& predictions) const;
  void AddSignal(const MeasuredHistory& history, const MeasuredSignal& signal, const Eigen::VectorXd& modelled,
                 Eigen::Ref<Eigen::VectorXd> out) const;

  std::shared_ptr<const CondensedVehicle> condensed_;
  std::vector<MeasuredHistory> histories_;
  Options options_;
  std::vector<HistorySimulation> simulations_;
  std::vector<KalmanPredictor> predictors_;
  std::vector<KalmanNoise> noise_;
  /// Sum of ln det S of all histories at the file's values.
  double reference_log_determinant_ = 0;
  Eigen::Index count_ = 0;
};

}  // namespace fourpost
