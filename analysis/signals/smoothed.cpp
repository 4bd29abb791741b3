#include "analysis/signals/smoothed.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "analysis/signals/deviation.h"

namespace fourpost {
namespace {

constexpr std::size_t kDifferences = 4;
/// Of a difference of fourth order.
constexpr std::array<double, kDifferences + 1> kDifference = {1, -4, 6, -4, 1};
constexpr std::size_t kFewestSmoothed = 64;
/// Weights of the differences: cut-offs from above half the sampling rate to a hundredth of it. Above, the equations
/// lose more digits than a converter has.
constexpr double kLeastWeight = 1e-3;
constexpr double kLargestWeight = 1e8;
/// Half a decade: a fifth of an octave in the cut-off.
constexpr double kFactor = 3.1622776601683795;
/// Of the weight that is best for the signal: its slope has lost by then what it cannot lose.
constexpr double kShare = 0.1;
/// Of the signal: louder is motion at few samples a period.
constexpr double kMostNoise = 0.1;

/// Lower half of a band of I + weight D'D: column k holds the entries of row k and of those below it.
using BandColumn = std::array<double, kDifferences + 1>;

/// Solves for the smooth signal by Cholesky's L D L' of the band.
std::vector<double> SmoothedBy(double weight, std::span<const double> signal) {
  const std::size_t n = signal.size();
  std::vector<BandColumn> band(n, BandColumn{1});
  for (std::size_t k = 0; k + kDifferences < n; ++k)
    for (std::size_t a = 0; a <= kDifferences; ++a)
      for (std::size_t b = a; b <= kDifferences; ++b) band[k + a][b - a] += weight * kDifference[a] * kDifference[b];
  std::vector<double> x(signal.begin(), signal.end());
  for (std::size_t k = 0; k < n; ++k) {
    BandColumn& pivot = band[k];
    for (std::size_t a = 1; a <= kDifferences && k + a < n; ++a) {
      const double factor = pivot[a] / pivot[0];
      for (std::size_t b = a; b <= kDifferences && k + b < n; ++b) band[k + a][b - a] -= factor * pivot[b];
      x[k + a] -= factor * x[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t a = 1; a <= kDifferences && k + a < n; ++a) x[k] -= band[k][a] * x[k + a];
    x[k] /= band[k][0];
  }
  return x;
}

/// How many of a signal's numbers stay free: the trace of the smoother, by the eigenvalues of a periodic one.
double FreeNumbers(double weight, std::size_t n) {
  double free = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double difference = 2 * std::sin(std::numbers::pi / 2 * static_cast<double>(k) / static_cast<double>(n));
    free += 1 / (1 + weight * std::pow(difference, 2 * kDifferences));
  }
  return free;
}

double SquaresOfDifference(std::span<const double> a, std::span<const double> b) {
  double squares = 0;
  for (std::size_t k = 0; k < a.size(); ++k) squares += (a[k] - b[k]) * (a[k] - b[k]);
  return squares;
}

}  // namespace

std::vector<double> WithoutNoise(std::span<const double> signal) {
  std::vector<double> as_it_is(signal.begin(), signal.end());
  if (signal.size() < kFewestSmoothed) return as_it_is;
  const auto n = static_cast<double>(signal.size());
  double least = std::numeric_limits<double>::infinity();
  double best = 0;
  double variance = 0;
  for (double weight = kLeastWeight; weight <= kLargestWeight; weight *= kFactor) {
    const double taken = n - FreeNumbers(weight, signal.size());
    const double squares = SquaresOfDifference(signal, SmoothedBy(weight, signal));
    const double criterion = n * squares / (taken * taken);
    if (!(criterion < least)) continue;
    least = criterion;
    best = weight;
    variance = squares / taken;
  }
  // Where the least weight is best there is nothing to be gained.
  const bool has_noise = best > kLeastWeight && std::sqrt(variance) < kMostNoise * DeviationOf(signal);
  return has_noise ? SmoothedBy(kShare * best, signal) : as_it_is;
}

}  // namespace fourpost
