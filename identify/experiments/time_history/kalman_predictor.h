#pragma once

#include <functional>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "analysis/process/deadline.h"
#include "identify/experiments/time_history/history_data.h"
#include "vehicles/condensed/condensed_model.h"

namespace fourpost {

/// What a Kalman filter takes for random.
struct KalmanNoise {
  /// Of each coordinate's acceleration, constant over a sample [m/s^2 or rad/s^2]: forces that the model has not.
  Eigen::VectorXd process_sd;
  /// Of each signal, white, in its unit.
  Eigen::VectorXd sensor_sd;
};

/// A model corrected by the measurement after each sample, as it predicts the next.
struct KalmanPrediction {
  /// Samples x signals: of each sample from all before it, offsets as in the measurement.
  Eigen::MatrixXd predicted;
  /// measured - predicted, and the same whitened by the covariance S that the filter gives them.
  Eigen::MatrixXd innovations;
  Eigen::MatrixXd whitened;
  /// Sum of ln det S.
  double log_determinant = 0;

  /// Minus twice the logarithm of the likelihood, without its constant.
  double Deviance() const { return log_determinant + whitened.squaredNorm(); }
};

/// How KalmanPredictor::Estimate goes about its search.
struct NoiseSearch {
  /// What one run of the filter may take [s of processor time].
  double deadline_s = std::numeric_limits<double>::infinity();
  /// Hears how many runs there were.
  std::function<void(int runs)> progress = {};
};

/// The Kalman filter as one-step predictor (thesis 4.5.2), x: states of the condensed vehicle,
///   x_k+1 = f(x_k) + w,  y_k = h(x_k) + v,  e = y - h(x),  K = P H' S^-1,  S = H P H' + R
/// with F = df/dx and H = dh/dx by differences of the condensed stepper, at every sample: the extended filter. Of a
/// linear vehicle they are the same at all samples: the linear one. The covariance is updated in Joseph's form.
///
/// The derivatives are of the state [s s' x] alone: a damper whose oil remembers has states that the filter would not
/// know, so that vehicles with hydraulic dampers are refused.
///
/// Posts and sensors are taken as recorded: where both went through one filter, a linear model fits them as they are,
/// and what a nonlinear one misses is process noise to this filter. Offsets of the signals are those of a simulation.
class KalmanPredictor {
 public:
  /// The history must outlive this. Throws std::invalid_argument for one whose filter has been taken back.
  explicit KalmanPredictor(const MeasuredHistory& history);

  /// Throws std::runtime_error where the motion cannot be computed, and TimedOut; std::invalid_argument for noise of
  /// another size or not above zero, and for a vehicle with hydraulic dampers.
  KalmanPrediction Run(const CondensedModel& model, const KalmanNoise& noise, const Deadline& deadline = {}) const;

  /// The noise under which the innovations are likeliest, by search along each logarithm in turn; of sensors, and of
  /// the process, whose noise the study states, that. State it where channels went through a filter: noise that changes
  /// slowly from sample to sample would pass for motion. Throws as Run() does.
  KalmanNoise Estimate(const CondensedModel& model, const NoiseSearch& search = {}) const;

 private:
  /// What Estimate() searches.
  std::vector<double*> Unknown(KalmanNoise& noise) const;

  const MeasuredHistory* history_;
  /// Of the record's samples from its first one to the end of the window.
  std::vector<PostState> posts_;
  Eigen::Index samples_ = 0;
};

}  // namespace fourpost
