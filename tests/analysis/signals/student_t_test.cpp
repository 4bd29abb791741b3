#include "analysis/signals/student_t.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace fourpost::student_t_test {
namespace {

// Percentage points to three decimals of Fisher and Yates, as in Abramowitz and Stegun, table 26.10.
TEST(StudentT, IsThatOfTheTables) {
  constexpr double kRounding = 5e-4;
  EXPECT_NEAR(StudentT95(1), 12.706, kRounding);
  EXPECT_NEAR(StudentT95(2), 4.303, kRounding);
  EXPECT_NEAR(StudentT95(5), 2.571, kRounding);
  EXPECT_NEAR(StudentT95(10), 2.228, kRounding);
  EXPECT_NEAR(StudentT95(29), 2.045, kRounding);
  EXPECT_NEAR(StudentT95(60), 2.000, kRounding);
  EXPECT_NEAR(StudentT95(120), 1.980, kRounding);
  EXPECT_NEAR(StudentT95(1e9), 1.959964, 1e-6);
}

// In closed form: tan(0.475 pi), and sqrt(2) 0.95 / sqrt(1 - 0.95^2).
TEST(StudentT, IsExactForOneAndTwoDegrees) {
  EXPECT_NEAR(StudentT95(1), 12.706204736432095, 1e-8);
  EXPECT_NEAR(StudentT95(2), 4.302652729696142, 1e-8);
}

// The series below 60 degrees and the expansion above.
TEST(StudentT, FallsWithoutAJump) {
  EXPECT_NEAR(StudentT95(59) - StudentT95(60), StudentT95(60) - StudentT95(61), 5e-5);
  for (double n = 1; n < 100; ++n) EXPECT_GT(StudentT95(n), StudentT95(n + 1)) << n;
}

TEST(StudentT, WantsADegreeOfFreedom) { EXPECT_THROW(StudentT95(0.5), std::invalid_argument); }

}  // namespace
}  // namespace fourpost::student_t_test
