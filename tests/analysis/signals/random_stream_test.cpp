#include "analysis/signals/random_stream.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::random_stream_test {
namespace {

TEST(RandomStream, IsAFunctionOfSeedAndStream) {
  RandomStream first(1, "noise", 2);
  RandomStream again(1, "noise", 2);
  RandomStream other_seed(2, "noise", 2);
  RandomStream other_stream(1, "noise", 3);
  RandomStream other_purpose(1, "road", 2);
  const double draw = first.Uniform();
  EXPECT_EQ(draw, again.Uniform());
  EXPECT_NE(draw, other_seed.Uniform());
  EXPECT_NE(draw, other_stream.Uniform());
  EXPECT_NE(draw, other_purpose.Uniform());
  EXPECT_NE(draw, first.Uniform());
}

TEST(RandomStream, IsUniform) {
  RandomStream stream(3, "test");
  std::vector<int> tenth(10);
  for (int k = 0; k < 100000; ++k) ++tenth[static_cast<std::size_t>(10 * stream.Uniform())];
  // Five standard deviations of sqrt(100000 x 0.1 x 0.9) = 95.
  for (const int count : tenth) EXPECT_NEAR(count, 10000, 475);
}

TEST(RandomStream, IsNormal) {
  RandomStream stream(4, "test");
  constexpr int kCount = 100000;
  double mean = 0;
  double square = 0;
  int beyond_two = 0;
  for (int k = 0; k < kCount; ++k) {
    const double draw = stream.Normal();
    mean += draw / kCount;
    square += draw * draw / kCount;
    beyond_two += std::abs(draw) > 2 ? 1 : 0;
  }
  // Five standard deviations each: 1/sqrt(N), sqrt(2/N), and of 4.55 % of N.
  EXPECT_NEAR(mean, 0, 0.016);
  EXPECT_NEAR(square, 1, 0.0224);
  EXPECT_NEAR(beyond_two, 4550, 330);
}

TEST(RandomStream, OfTwoPurposesHasNothingInCommon) {
  RandomStream noise(5, "channel noise", 1);
  RandomStream road(5, "road alike", 1);
  constexpr int kCount = 100000;
  double product = 0;
  for (int k = 0; k < kCount; ++k) product += noise.Normal() * road.Normal() / kCount;
  // Five standard deviations of 1/sqrt(N).
  EXPECT_NEAR(product, 0, 0.016);
}

}  // namespace
}  // namespace fourpost::random_stream_test
