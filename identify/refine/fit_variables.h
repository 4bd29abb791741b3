#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/search/lattice.h"

namespace fourpost {

/// Variables in which a gradient fit and its uncertainty are expressed: x = ln p for a parameter whose lower bound is
/// positive, so that dx is a relative change; else x = (p - lower) / (upper - lower), a share of the range.
class FitVariables {
 public:
  explicit FitVariables(const Lattice& lattice);

  Eigen::Index size() const { return lower_.size(); }
  bool is_logarithmic(Eigen::Index j) const { return lower_[j] > 0; }
  /// Bounds of x.
  const Eigen::VectorXd& lower() const { return lower_x_; }
  const Eigen::VectorXd& upper() const { return upper_x_; }

  /// Throws std::invalid_argument naming the parameter that is not within its bounds.
  Eigen::VectorXd FromValues(const Eigen::VectorXd& values) const;

  /// Within the bounds to the last bit, whatever the rounding, and exactly a bound at the bound of x or beyond.
  Eigen::VectorXd ToValues(const Eigen::VectorXd& x) const;

  /// dp/dx at these values: p, or upper - lower.
  Eigen::VectorXd Slopes(const Eigen::VectorXd& values) const;

 private:
  double Forward(Eigen::Index j, double value) const;
  double Backward(Eigen::Index j, double x) const;

  std::vector<std::string> names_;
  Eigen::VectorXd lower_;
  Eigen::VectorXd upper_;
  Eigen::VectorXd lower_x_;
  Eigen::VectorXd upper_x_;
};

}  // namespace fourpost
