#include "analysis/numerics/bessel.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace fourpost::bessel_test {
namespace {

TEST(BesselK1, IsThatOfTheStandardLibraryToRounding) {
  for (double x = 1e-6; x < 600; x *= 1.05) EXPECT_NEAR(BesselK1(x) / std::cyl_bessel_k(1, x), 1, 1e-14) << x;
}

// DLMF 10.30.2.
TEST(BesselK1, GrowsAsTheInverseNearZero) { EXPECT_NEAR(1e-9 * BesselK1(1e-9), 1, 1e-14); }

TEST(BesselK1, EndsForWhatIsNoNumber) { EXPECT_TRUE(std::isnan(BesselK1(std::numeric_limits<double>::quiet_NaN()))); }

TEST(ScaledBesselI1, IsThatOfTheStandardLibrary) {
  // Near zero the sum of the rule cancels to its rounding.
  for (double x = 1e-3; x < 600; x *= 1.05) {
    const double expected = std::exp(-x) * std::cyl_bessel_i(1, x);
    EXPECT_NEAR(ScaledBesselI1(x), expected, 1e-13 * expected + 1e-15) << x;
  }
  EXPECT_NEAR(ScaledBesselI1(0), 0, 1e-15);
  // Where one formula follows the other.
  EXPECT_NEAR(ScaledBesselI1(std::nextafter(1000.0, 2000.0)) / ScaledBesselI1(1000), 1, 1e-12);
}

}  // namespace
}  // namespace fourpost::bessel_test
