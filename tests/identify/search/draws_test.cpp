#include "identify/search/draws.h"

#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::draws_test {
namespace {

Draws Stream(std::uint64_t seed = 1) { return Draws(seed, DrawPurpose::kTrial, 0, 0); }

// Pearson's sum over equally likely classes.
template <std::size_t N>
double ChiSquare(const std::array<int, N>& counts, int draws) {
  const double expected = static_cast<double>(draws) / N;
  double sum = 0;
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

// First outputs of the authors' generator from the seed 0.
TEST(Draws, MixBitsIsSplitMix64) {
  const std::uint64_t increment = 0x9e3779b97f4a7c15u;
  EXPECT_EQ(MixBits(0), 0xe220a8397b1dcdafu);
  EXPECT_EQ(MixBits(increment), 0x6e789e6aa1b965f4u);
  EXPECT_EQ(MixBits(2 * increment), 0x06c45d188009454fu);
}

TEST(Draws, AreAPureFunctionOfTheirPlace) {
  Draws a(7, DrawPurpose::kMigration, 3, 5);
  Draws b(7, DrawPurpose::kMigration, 3, 5);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.Bits(), b.Bits());
}

TEST(Draws, DifferWithEachPartOfTheirPlace) {
  std::set<std::uint64_t> first;
  std::size_t streams = 0;
  for (const DrawPurpose purpose :
       {DrawPurpose::kInitial, DrawPurpose::kFactor, DrawPurpose::kTrial, DrawPurpose::kMigration, DrawPurpose::kStart,
        DrawPurpose::kBootstrap, DrawPurpose::kLine, DrawPurpose::kNoise, DrawPurpose::kProbe}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      for (std::int64_t generation = 0; generation < 10; ++generation) {
        for (std::size_t individual = 0; individual < 10; ++individual, ++streams) {
          first.insert(Draws(seed, purpose, generation, individual).Bits());
        }
      }
    }
  }
  EXPECT_EQ(first.size(), streams);
}

TEST(Draws, UniformIsWithinZeroAndOneAndEven) {
  Draws draws = Stream();
  std::array<int, 20> counts = {};
  for (int i = 0; i < 20000; ++i) {
    const double u = draws.Uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    ++counts[static_cast<std::size_t>(20 * u)];
  }
  // 99.99 % quantile of chi-square, 19 degrees of freedom.
  EXPECT_LT(ChiSquare(counts, 20000), 50.8);
}

TEST(Draws, FirstDrawsOfNeighbouringStreamsAreEvenToo) {
  std::array<int, 20> counts = {};
  for (std::size_t i = 0; i < 20000; ++i) {
    ++counts[static_cast<std::size_t>(20 * Draws(1, DrawPurpose::kTrial, 4, i).Uniform())];
  }
  EXPECT_LT(ChiSquare(counts, 20000), 50.8);  // as above
}

TEST(Draws, IntegerReachesBothBoundsEvenly) {
  Draws draws = Stream();
  std::array<int, 7> counts = {};
  for (int i = 0; i < 7000; ++i) {
    const std::int64_t n = draws.Integer(-3, 3);
    ASSERT_GE(n, -3);
    ASSERT_LE(n, 3);
    ++counts[static_cast<std::size_t>(n + 3)];
  }
  // 99.99 % quantile of chi-square, 6 degrees of freedom.
  EXPECT_LT(ChiSquare(counts, 7000), 27.9);
}

// Of 3 2^61 values, the remainder of 64 bits alone would give each of the first 2/3 three times for two of the last
// 1/3.
TEST(Draws, IntegerIsEvenOverLargeRangesToo) {
  Draws draws = Stream();
  const std::int64_t third = std::int64_t{1} << 61;
  std::array<int, 3> counts = {};
  for (int i = 0; i < 9000; ++i) ++counts[static_cast<std::size_t>(draws.Integer(0, 3 * third - 1) / third)];
  // 99.99 % quantile of chi-square, 2 degrees of freedom.
  EXPECT_LT(ChiSquare(counts, 9000), 18.4);
}

TEST(Draws, IntegerOfOneValueIsThatValue) {
  Draws draws = Stream();
  EXPECT_EQ(draws.Integer(5, 5), 5);
}

// 10000 draws: 4 standard deviations of mean and variance.
TEST(Draws, NormalHasItsMoments) {
  Draws draws = Stream(3);
  double sum = 0, squares = 0;
  for (int i = 0; i < 10000; ++i) {
    const double x = draws.Normal();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / 10000, 0, 4 / std::sqrt(10000));
  EXPECT_NEAR(squares / 10000, 1, 4 * std::sqrt(2.0 / 10000));
}

}  // namespace
}  // namespace fourpost::draws_test
