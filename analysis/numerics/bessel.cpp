#include "analysis/numerics/bessel.h"

#include <algorithm>
#include <cmath>

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

}  // namespace fourpost
