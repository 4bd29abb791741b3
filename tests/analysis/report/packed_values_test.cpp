#include "analysis/report/packed_values.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace fourpost::packed_values_test {
namespace {

TEST(PackedValues, OfEvenTimesAreTwoNumbers) {
  std::vector<double> times;
  for (int i = 0; i < 1000; ++i) times.push_back(2 + 0.002 * i);
  const auto json = PackedValues(times);
  EXPECT_EQ(json["rows"], 1000);
  EXPECT_EQ(json["first"], 2.0);
  // Rounding.
  EXPECT_NEAR(json["step"], 0.002, 1e-15);
  times[500] += 0.001;
  EXPECT_TRUE(PackedValues(times).contains("packed"));
}

// The page's script unpacks them in tests/report/modules.test.mjs.
TEST(PackedValues, TakeLessThanTwoBytesOfNoise) {
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  std::vector<double> values;
  double slow = 0;
  for (int i = 0; i < 10000; ++i) values.push_back((slow += 0.01 * normal(generator)) + 1e-4 * normal(generator));
  const auto json = PackedValues(values);
  const std::string packed = json["packed"];
  // Base 64 writes 4 digits for 3 bytes.
  EXPECT_LT(packed.size(), 2.0 * 10000 * 4 / 3);
}

TEST(PackedValues, OfNothingAndOfOneNumberAreThere) {
  EXPECT_EQ(PackedValues({})["rows"], 0);
  EXPECT_EQ(PackedValues({3.0})["rows"], 1);
  EXPECT_EQ(PackedValues({0.0, 0.0})["scale"], 1.0);
  EXPECT_TRUE(PackedValues({NAN, 1.0}).contains("packed"));
}

}  // namespace
}  // namespace fourpost::packed_values_test
