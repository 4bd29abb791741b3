#pragma once

#include <vector>

namespace fourpost {

/// A signal through samples at start + k step: the cubic spline of continuous value, slope and curvature with given
/// slopes at both ends. Before its start and after its end it keeps the value there and rests. Between samples of a
/// sine of n samples per period its value errs by (2 pi / n)^4 / 384 of the amplitude, its curvature by
/// (2 pi / n)^2 / 12 of its own.
class UniformSpline {
 public:
  struct Point {
    double value = 0;
    double slope = 0;
    double curvature = 0;
  };

  /// Throws std::invalid_argument unless step > 0, there are two samples at least, and all numbers are finite.
  UniformSpline(double start, double step, std::vector<double> values, double first_slope = 0, double last_slope = 0);

  double start() const { return start_; }
  double end() const { return start_ + step_ * static_cast<double>(values_.size() - 1); }

  Point At(double t) const;

 private:
  double start_;
  double step_;
  std::vector<double> values_;
  /// At the samples.
  std::vector<double> curvatures_;
};

/// Slope at the first of four samples or more, of the cubic through the first four; of two or three that of the
/// straight line through the first two.
double SlopeAtStart(const std::vector<double>& values, double step);

}  // namespace fourpost
