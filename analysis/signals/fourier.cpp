#include "analysis/signals/fourier.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/QR>

namespace fourpost {
namespace {

using std::numbers::pi;

/// exp(-2 pi i k / size) for k = 0..size-1.
std::vector<std::complex<double>> RootsOfUnity(std::size_t size) {
  std::vector<std::complex<double>> roots(size);
  for (std::size_t k = 0; k < size; ++k)
    roots[k] = std::polar(1.0, -2 * pi * static_cast<double>(k) / static_cast<double>(size));
  return roots;
}

void CheckWholeCycles(std::size_t size, int cycles, int count) {
  if (cycles < 1) throw std::invalid_argument("harmonics need at least one cycle, not " + std::to_string(cycles));
  if (count < 0) throw std::invalid_argument("the number of harmonics must not be negative");
  if (!(2.0 * count * cycles < static_cast<double>(size)))
    throw std::invalid_argument(std::to_string(count) + " harmonics of " + std::to_string(cycles) +
                                " cycles need more than " + std::to_string(2LL * count * cycles) + " samples, not " +
                                std::to_string(size));
}

void CheckLeastSquares(std::size_t size, double samples_per_cycle, int count) {
  if (count < 0) throw std::invalid_argument("the number of harmonics must not be negative");
  if (!(samples_per_cycle > 2.0 * count))
    throw std::invalid_argument(std::to_string(count) + " harmonics need more than " + std::to_string(2LL * count) +
                                " samples a cycle, not " + std::to_string(samples_per_cycle));
  // So many are enough for the 2 count + 1 unknowns, too.
  if (!(static_cast<double>(size) >= samples_per_cycle))
    throw std::invalid_argument(std::to_string(size) + " samples are less than a cycle of " +
                                std::to_string(samples_per_cycle));
}

/// Rows are samples; columns 1, cos wt, sin wt, cos 2wt, ...
Eigen::MatrixXd HarmonicBasis(Eigen::Index size, double samples_per_cycle, Eigen::Index count) {
  Eigen::MatrixXd basis(size, 2 * count + 1);
  for (Eigen::Index n = 0; n < size; ++n) {
    basis(n, 0) = 1;
    for (Eigen::Index h = 1; h <= count; ++h) {
      const double angle = 2 * pi * static_cast<double>(h) * static_cast<double>(n) / samples_per_cycle;
      basis(n, 2 * h - 1) = std::cos(angle);
      basis(n, 2 * h) = std::sin(angle);
    }
  }
  return basis;
}

}  // namespace

Eigen::VectorXcd Harmonics(std::span<const double> samples, int cycles, int count) {
  const std::size_t size = samples.size();
  CheckWholeCycles(size, cycles, count);
  const std::vector<std::complex<double>> roots = RootsOfUnity(size);
  Eigen::VectorXcd harmonics = Eigen::VectorXcd::Zero(count + 1);
  for (int h = 0; h <= count; ++h) {
    const std::size_t step = static_cast<std::size_t>(h) * static_cast<std::size_t>(cycles);
    for (std::size_t n = 0; n < size; ++n) harmonics(h) += samples[n] * roots[step * n % size];
  }
  harmonics *= 2 / static_cast<double>(size);
  harmonics(0) /= 2;
  return harmonics;
}

Eigen::VectorXcd HarmonicsByLeastSquares(std::span<const double> samples, double samples_per_cycle, int count) {
  CheckLeastSquares(samples.size(), samples_per_cycle, count);
  const Eigen::Map<const Eigen::VectorXd> signal(samples.data(), static_cast<Eigen::Index>(samples.size()));
  const Eigen::VectorXd fitted = HarmonicBasis(signal.size(), samples_per_cycle, count).householderQr().solve(signal);
  Eigen::VectorXcd harmonics(count + 1);
  harmonics(0) = fitted(0);
  // Re (a - i b) exp(i x) = a cos x + b sin x.
  for (Eigen::Index h = 1; h <= count; ++h) harmonics(h) = {fitted(2 * h - 1), -fitted(2 * h)};
  return harmonics;
}

}  // namespace fourpost
