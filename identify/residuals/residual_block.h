#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/process/deadline.h"
#include "identify/residuals/residual_structure.h"
#include "identify/search/evaluation.h"

namespace fourpost {

class CondensedVehicle;

/// Another vehicle with the same posts and sensors, at values of its own parameters, SI.
struct OtherVehicle {
  std::shared_ptr<const CondensedVehicle> vehicle;
  std::vector<double> values;
};

/// How far a vehicle is from one kind of data, as whitened residuals.
struct ResidualBlock {
  /// "four-post responses", "static loads", ...
  std::string name;
  /// Residuals it gives.
  Eigen::Index count = 0;
  /// Of the solver behind it, relative; see Problem.
  double accuracy = 1e-15;
  /// `values`: all parameters of the vehicle, SI. Called from several threads at once. Throws TimedOut.
  std::function<Evaluation(const std::vector<double>& values, const Deadline& deadline)> evaluate;
  /// Derivatives by these parameters (indices) per SI unit, count x parameters, for less than differences would cost
  /// and good enough for steps of a refinement; empty where only differences give them. Throws what it cannot do.
  std::function<Eigen::MatrixXd(const std::vector<double>& values, const std::vector<std::size_t>& parameters)>
      differentiate = {};
  /// What residuals change by with each other vehicle in this one's place, to first order in all that is different,
  /// count x others, for much less than evaluating each; NaN for one that it does not know. Empty where there is no
  /// such way. Throws what it cannot do.
  std::function<Eigen::MatrixXd(const std::vector<double>& values, std::span<const OtherVehicle> others)> toward = {};
  /// Residuals with a quarter of the integration's step; empty where nothing is integrated. Throws std::runtime_error
  /// where they cannot be computed.
  std::function<Eigen::VectorXd(const std::vector<double>& values)> at_finer_steps = {};
  /// What one standard deviation of each calibration that the study states would change in the residuals, count x
  /// calibrations, to first order; empty: nothing is stated. Throws std::runtime_error where it cannot be computed.
  std::function<Eigen::MatrixXd(const std::vector<double>& values)> by_calibrations = {};
  /// For what is known of the parameters; empty: nothing beyond that all residuals are independent.
  ResidualStructure structure = {};
  /// Two: the same block with noise added to its inputs, and with that noise taken away, like the noise that is in them
  /// already, as far as residuals at `values` show it. What it changes shows what the noise that is there has changed.
  /// Returns none where there is no noise; empty where inputs have none. Throws std::runtime_error where it cannot be
  /// found.
  std::function<std::vector<ResidualBlock>(const std::vector<double>& values)> with_input_noise = {};
  /// Some of these residuals, for much less, with a minimum near that of all; null where there are no such. A
  /// refinement may be led by them.
  std::shared_ptr<const ResidualBlock> coarse = nullptr;
  /// Takes next to no time beside others, so that no coarse ones are needed.
  bool is_cheap = false;
};

}  // namespace fourpost
