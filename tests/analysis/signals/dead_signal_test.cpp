#include "analysis/signals/dead_signal.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/signals/random_stream.h"

namespace fourpost::dead_signal_test {
namespace {

/// A sine of `amplitude` levels and of a hundred samples a period, with noise of `noise` levels.
std::vector<double> Recorded(double amplitude, double noise) {
  RandomStream random(1, "dead");
  std::vector<double> values(5000);
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = 0.005 * std::round(amplitude * std::sin(0.0628 * static_cast<double>(k)) + noise * random.Normal());
  return values;
}

TEST(DeadSignal, HasNoiseOfItsConverterAlone) {
  EXPECT_TRUE(IsDead(Recorded(0, 0.4)));
  EXPECT_TRUE(IsDead(Recorded(0, 1.5)));
  EXPECT_FALSE(IsDead(Recorded(0, 3)));
}

// However coarse the converter is.
TEST(DeadSignal, IsNoneThatMoves) {
  EXPECT_FALSE(IsDead(Recorded(1.6, 0)));
  EXPECT_FALSE(IsDead(Recorded(1.6, 0.4)));
}

TEST(DeadSignal, IsNoConstant) { EXPECT_FALSE(IsDead(std::vector<double>(5000, 0.005))); }

}  // namespace
}  // namespace fourpost::dead_signal_test
