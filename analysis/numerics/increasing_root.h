#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fourpost {

/// Root of f(x) = `target` for an increasing function f between `lower` and `upper`: Newton's method from `start`, with
/// bisection if a step would leave the bracket or the last one gained less than half. f(x) returns {value, slope}. To
/// rounding: |f - target| <= 4 ulp of the target, or steps of 4 ulp of x; `close`: or steps as small as this. At most
/// 100 evaluations. NaN for a NaN.
template <typename Function>
double IncreasingRoot(const Function& f, double target, double lower, double upper, double start, double close = 0) {
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  constexpr int kMostEvaluations = 100;
  double x = start;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostEvaluations; ++i) {
    const auto [value, slope] = f(x);
    const double residual = value - target;
    if (std::isnan(residual)) return residual;
    if (std::abs(residual) <= kRounding * std::abs(target)) return x;
    (residual > 0 ? upper : lower) = x;
    double next = x - residual / slope;
    const bool gains = std::abs(residual) <= 0.5 * last;
    if (!(gains && next >= lower && next <= upper)) next = lower + 0.5 * (upper - lower);
    if (std::abs(next - x) <= std::max(kRounding * std::abs(x), close)) return next;
    last = std::abs(residual);
    x = next;
  }
  return x;
}

}  // namespace fourpost
