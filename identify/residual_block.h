#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/deadline.h"
#include "identify/search/evaluation.h"

namespace fourpost {

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
};

}  // namespace fourpost
