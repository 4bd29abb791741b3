#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/deadline.h"
#include "identify/history_data.h"
#include "identify/history_simulation.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {

/// How far a vehicle is from histories, as residuals. Whitened:
///   (modelled - measured) / sqrt(noise^2 + (model error s)^2) at every MeasuredHistory::Stride-th sample,
/// s: the signal's own deviation; no noise is white behind a filter at the full rate. By compromise (thesis 4.29):
///   J_k r_k / |r_k|, J_k = |r_k|^2 the signal's normalised mean square error [%],
/// whose squares add up to the sum of all J_k^2, with weights 1 and aims 0. Immutable; serves any number of threads.
class HistoryResiduals {
 public:
  struct Options {
    HistoryCost cost = HistoryCost::kWhitened;
    /// What the model leaves out, as a share of each signal's deviation.
    double model_error = 0.02;
    /// Of the integration, of each channel's rms; a thousandth changes no mean square error in its third digit.
    double error = 1e-3;
  };

  /// Steps are those that the vehicle needs at its file's values. Throws FaultyInput as CondensedVehicle does.
  HistoryResiduals(const Vehicle& vehicle, std::vector<MeasuredHistory> histories, const Options& options);

  Eigen::Index count() const { return count_; }

  /// `values`: all parameters of the vehicle, SI. Throws TimedOut, and std::runtime_error where the motion cannot be
  /// computed.
  Eigen::VectorXd At(const std::vector<double>& values, const Deadline& deadline = {}) const;

  /// Per history, samples of the window x signals.
  std::vector<Eigen::MatrixXd> Modelled(const std::vector<double>& values) const;

  const std::vector<MeasuredHistory>& histories() const { return histories_; }
  /// Of each history [s].
  std::vector<double> Steps() const;

 private:
  void AddSignal(const MeasuredHistory& history, const MeasuredSignal& signal, const Eigen::VectorXd& modelled,
                 Eigen::Ref<Eigen::VectorXd> out) const;

  CondensedVehicle condensed_;
  std::vector<MeasuredHistory> histories_;
  Options options_;
  std::vector<HistorySimulation> simulations_;
  Eigen::Index count_ = 0;
};

/// How well a model shows a signal of a history.
struct HistoryMisfit {
  std::string recording;
  std::string name;
  std::string unit;
  double nmse_percent = 0;
  double vaf_percent = 0;
  /// What a straight line of the model makes of the measurement: measured = gain modelled(t - delay). A gain below 0
  /// is a wrong sign.
  double gain = 1;
  /// By how much the measurement comes later than the model [s].
  double delay_s = 0;
};

std::vector<HistoryMisfit> HistoryMisfits(const std::vector<MeasuredHistory>& histories,
                                          const std::vector<Eigen::MatrixXd>& modelled);

}  // namespace fourpost
