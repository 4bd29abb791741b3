#include "analysis/signals/uniform_spline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

/// Solves M[k-1] + 4 M[k] + M[k+1] = right[k], with 2 in place of 4 in the first and the last row (Thomas algorithm).
std::vector<double> SolveCurvatures(std::vector<double> right) {
  const std::size_t count = right.size();
  std::vector<double> above(count);
  double diagonal = 2;
  above[0] = 1 / diagonal;
  right[0] /= diagonal;
  for (std::size_t k = 1; k < count; ++k) {
    diagonal = (k + 1 < count ? 4 : 2) - above[k - 1];
    above[k] = 1 / diagonal;
    right[k] = (right[k] - right[k - 1]) / diagonal;
  }
  for (std::size_t k = count - 1; k-- > 0;) right[k] -= above[k] * right[k + 1];
  return right;
}

}  // namespace

UniformSpline::UniformSpline(double start, double step, std::vector<double> values, double first_slope,
                             double last_slope)
    : start_(start), step_(step), values_(std::move(values)) {
  RequireOption(std::isfinite(start), "UniformSpline: start", start, "finite");
  RequireOption(step > 0 && std::isfinite(step), "UniformSpline: step", step, "positive and finite");
  RequireOption(values_.size() >= 2, "UniformSpline: samples", values_.size(), "two at least");
  for (const double value : values_) RequireOption(std::isfinite(value), "UniformSpline: value", value, "finite");
  const std::size_t last = values_.size() - 1;
  std::vector<double> right(values_.size());
  const double scale = 6 / (step * step);
  right[0] = scale * (values_[1] - values_[0] - step * first_slope);
  right[last] = scale * (step * last_slope - (values_[last] - values_[last - 1]));
  for (std::size_t k = 1; k < last; ++k) right[k] = scale * (values_[k + 1] - 2 * values_[k] + values_[k - 1]);
  curvatures_ = SolveCurvatures(std::move(right));
}

UniformSpline::Point UniformSpline::At(double t) const {
  const double place = (t - start_) / step_;
  const auto last = static_cast<double>(values_.size() - 1);
  if (place < 0) return {.value = values_.front()};
  if (place > last) return {.value = values_.back()};
  const auto k = static_cast<std::size_t>(std::min(place, last - 1));
  const double b = place - static_cast<double>(k);
  const double a = 1 - b;
  const double left = curvatures_[k];
  const double right = curvatures_[k + 1];
  const double square = step_ * step_;
  return {a * values_[k] + b * values_[k + 1] + ((a * a - 1) * a * left + (b * b - 1) * b * right) * square / 6,
          (values_[k + 1] - values_[k]) / step_ + ((1 - 3 * a * a) * left + (3 * b * b - 1) * right) * step_ / 6,
          a * left + b * right};
}

double SlopeAtStart(const std::vector<double>& values, double step) {
  if (values.size() < 4) return (values.at(1) - values.at(0)) / step;
  return (-11 * values[0] + 18 * values[1] - 9 * values[2] + 2 * values[3]) / (6 * step);
}

}  // namespace fourpost
