#include "vehicles/random_response/spectral_grid.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

namespace fourpost::spectral_grid_test {
namespace {

double Integral(const SpectralGrid& grid, const std::function<double(double)>& density) {
  double sum = 0;
  for (std::size_t k = 0; k < grid.size(); ++k) sum += grid.share_Hz[k] * density(grid.frequency_Hz[k]);
  return sum;
}

TEST(SpectralGrid, IntegratesPowersOfFrequency) {
  const SpectralGrid grid = SpectralGrid::For(0.5, 30, 0);
  EXPECT_NEAR(Integral(grid, [](double) { return 1; }), 29.5, 1e-11);
  EXPECT_NEAR(Integral(grid, [](double f) { return 1 / (f * f); }), 2 - 1.0 / 30, 1e-11);
}

// f0^3 / ((f0^2 - f^2)^2 + (2 D f0 f)^2) over all frequencies: pi / (4 D), of an oscillator under white force.
TEST(SpectralGrid, IntegratesAResonance) {
  for (const double damping : {0.02, 0.1, 0.3}) {
    const SpectralGrid grid = SpectralGrid::For(1e-4, 1e4, 0, damping);
    const double integral = Integral(grid, [&](double f) {
      return std::pow(7.0, 3) / (std::pow(49 - f * f, 2) + std::pow(2 * damping * 7 * f, 2));
    });
    EXPECT_NEAR(integral / (std::numbers::pi / (4 * damping)), 1, 2e-4) << damping;
  }
}

TEST(SpectralGrid, FollowsTheWavesOfADelay) {
  constexpr double kDelay = 0.9;
  const SpectralGrid grid = SpectralGrid::For(0.5, 30, kDelay);
  const double w = 2 * std::numbers::pi * kDelay;
  const double exact = 29.5 + (std::sin(w * 30) - std::sin(w * 0.5)) / w;
  EXPECT_NEAR(Integral(grid, [&](double f) { return 1 + std::cos(w * f); }), exact, 1e-4 * exact);
  EXPECT_GT(grid.size(), SpectralGrid::For(0.5, 30, 0).size());
}

TEST(SpectralGrid, IsFinerByItsRefinement) {
  EXPECT_GT(2 * SpectralGrid::For(0.5, 30, 0.2, 0.1, 2).size(), 3 * SpectralGrid::For(0.5, 30, 0.2, 0.1, 1).size());
}

}  // namespace
}  // namespace fourpost::spectral_grid_test
