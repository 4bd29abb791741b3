#include "analysis/numerics/bessel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fourpost {

// K1(x) = integral over t > 0 of exp(-x cosh t) cosh t dt (DLMF 10.32.9), by the trapezoidal rule, which errs by
// exp(-pi^2 / step) of this integrand, and by exp(-2 pi^2 / (x step^2)) where it is a narrow bell.
double BesselK1(double x) {
  constexpr double kLargestExponent = 40;
  const double step = std::min(0.2, 0.6 / std::sqrt(x));
  double sum = 0.5;
  // Ends for NaN as well.
  for (int k = 1;; ++k) {
    const double half = std::sinh(0.5 * k * step);
    const double exponent = 2 * x * half * half;
    if (!(exponent <= kLargestExponent)) break;
    sum += std::exp(-exponent) * (1 + 2 * half * half);
  }
  return step * sum * std::exp(-x);
}

// I1(x) = integral over t from 0 to pi of exp(x cos t) cos t dt / pi (DLMF 10.32.3), by the trapezoidal rule, which
// errs by exp(-2 n^2 / x) for n midpoints where that is a narrow bell; from x = 1000 on four terms of DLMF 10.40.1.
double ScaledBesselI1(double x) {
  constexpr double kLarge = 1000;
  if (x > kLarge) return (1 - (3 + (7.5 + 52.5 / (8 * x)) / (8 * x)) / (8 * x)) / std::sqrt(2 * std::numbers::pi * x);
  if (!(x >= 0)) return std::numeric_limits<double>::quiet_NaN();
  const int points = 12 + static_cast<int>(std::ceil(4 * std::sqrt(x)));
  double sum = 0;
  for (int k = 0; k < points; ++k) {
    const double cosine = std::cos(std::numbers::pi * (k + 0.5) / points);
    sum += cosine * std::exp(x * (cosine - 1));
  }
  return sum / points;
}

}  // namespace fourpost
