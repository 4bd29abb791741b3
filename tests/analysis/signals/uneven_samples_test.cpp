#include "analysis/signals/uneven_samples.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace fourpost::uneven_samples_test {
namespace {

TEST(UnevenSamples, ParabolasAreExact) {
  const std::vector<double> times = {0, 0.1, 0.35, 0.4, 0.9};
  const auto parabola = [](double t) { return 3 - 2 * t + 5 * t * t; };
  std::vector<double> values;
  for (const double t : times) values.push_back(parabola(t));
  const std::vector<double> at = {0, 0.05, 0.2, 0.37, 0.4, 0.7, 0.9, 0.01};
  const std::vector<double> interpolated = InterpolatedAt(times, values, at);
  for (std::size_t k = 0; k < at.size(); ++k) EXPECT_NEAR(interpolated[k], parabola(at[k]), 1e-14) << at[k];
}

TEST(UnevenSamples, ErrorFallsWithTheThirdPowerOfTheSpacing) {
  const auto error = [](double step) {
    std::vector<double> times;
    std::vector<double> values;
    for (int k = 0; k <= static_cast<int>(2 / step); ++k) {
      times.push_back(step * (k + 0.3 * std::sin(k)));
      values.push_back(std::sin(3 * times.back()));
    }
    std::vector<double> at;
    for (double t = 0.5; t < 1.5; t += 0.003) at.push_back(t);
    const std::vector<double> interpolated = InterpolatedAt(times, values, at);
    double worst = 0;
    for (std::size_t k = 0; k < at.size(); ++k)
      worst = std::max(worst, std::abs(interpolated[k] - std::sin(3 * at[k])));
    return worst;
  };
  // 8 for third order, less what the last interval of each happens to be.
  EXPECT_GT(error(0.05) / error(0.025), 6);
}

// As a clipped signal, which is known by it; beside it the cubic stays below.
TEST(UnevenSamples, StandBetweenEqualSamples) {
  const std::vector<double> times = {0, 1, 2.1, 3, 4.2, 5, 6};
  const std::vector<double> values = {0.1, 0.7, 0.9, 0.9, 0.9, 0.9, 0.2};
  std::vector<double> at;
  for (double t = 0; t < 6; t += 0.013) at.push_back(t);
  const std::vector<double> interpolated = InterpolatedAt(times, values, at);
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (at[k] >= 2.1 && at[k] <= 5) EXPECT_EQ(interpolated[k], 0.9) << at[k];
    else EXPECT_LE(interpolated[k], 0.9) << at[k];
  }
}

TEST(UnevenSamples, RefusesTimesThatDoNotRise) {
  const std::vector<double> values = {1, 2, 3};
  EXPECT_THROW(InterpolatedAt(std::vector<double>{0, 1, 1}, values, values), std::invalid_argument);
  EXPECT_THROW(InterpolatedAt(std::vector<double>{0, 1}, std::vector<double>{0, 1}, values), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::uneven_samples_test
