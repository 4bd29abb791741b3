#include "analysis/signals/student_t.h"

#include <cmath>

#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

/// Share of Student's distribution within -t and t, for a whole number of degrees: the finite series of Abramowitz and
/// Stegun, Handbook of Mathematical Functions, 26.7.3 and 26.7.4.
double ShareWithin(double t, int degrees) {
  constexpr double kPi = 3.14159265358979323846;
  const double angle = std::atan(t / std::sqrt(degrees));
  const double cosine2 = std::cos(angle) * std::cos(angle);
  const bool is_odd = degrees % 2 == 1;
  double term = is_odd ? std::cos(angle) : 1;
  double sum = degrees == 1 ? 0 : term;
  for (int k = is_odd ? 3 : 2; k <= degrees - 2; k += 2) sum += term *= cosine2 * (k - 1) / k;
  return is_odd ? 2 / kPi * (angle + std::sin(angle) * sum) : std::sin(angle) * sum;
}

double ByBisection(int degrees) {
  double lower = 1.9;
  double upper = 13;
  while (upper - lower > 1e-9) {
    const double middle = (lower + upper) / 2;
    (ShareWithin(middle, degrees) < 0.95 ? lower : upper) = middle;
  }
  return (lower + upper) / 2;
}

/// Abramowitz and Stegun 26.7.5.
double ByExpansion(double degrees) {
  constexpr double z = 1.959963984540054;
  constexpr double z2 = z * z;
  const double first = z * (z2 + 1) / 4;
  const double second = z * ((5 * z2 + 16) * z2 + 3) / 96;
  const double third = z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
  return z + (first + (second + third / degrees) / degrees) / degrees;
}

}  // namespace

double StudentT95(double degrees_of_freedom) {
  // Where the expansion is good to 1e-7.
  constexpr double kMany = 60;
  RequireOption(degrees_of_freedom >= 1, "degrees of freedom", degrees_of_freedom, "1 or more");
  return degrees_of_freedom < kMany ? ByBisection(static_cast<int>(degrees_of_freedom))
                                    : ByExpansion(degrees_of_freedom);
}

}  // namespace fourpost
