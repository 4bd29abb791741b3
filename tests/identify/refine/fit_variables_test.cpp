#include "identify/refine/fit_variables.h"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fourpost::fit_variables_test {
namespace {

using testing::StrEq;
using testing::ThrowsMessage;

constexpr double kEpsilon = 2.220446049250313e-16;

// Logarithmic, a share of the range, and a share again since zero has no logarithm.
Lattice ThreeAxes() { return Lattice({{"mass", 50, 800, 0.1}, {"offset", -2, 8, 0.1}, {"friction", 0, 400, 1}}); }

TEST(FitVariables, AreLogarithmicWhereTheLowerBoundIsPositive) {
  const FitVariables variables(ThreeAxes());
  EXPECT_TRUE(variables.is_logarithmic(0));
  EXPECT_FALSE(variables.is_logarithmic(1));
  EXPECT_FALSE(variables.is_logarithmic(2));
  EXPECT_EQ(variables.FromValues(Eigen::Vector3d(200, 3, 100)), Eigen::Vector3d(std::log(200), 0.5, 0.25));
  EXPECT_EQ(variables.lower(), Eigen::Vector3d(std::log(50), 0, 0));
  EXPECT_EQ(variables.upper(), Eigen::Vector3d(std::log(800), 1, 1));
}

TEST(FitVariables, GoThereAndBack) {
  const FitVariables variables(ThreeAxes());
  for (const Eigen::Vector3d& values : {Eigen::Vector3d(50, -2, 0), {123.4, 0.7, 3}, {800, 8, 400}}) {
    // Rounding: a logarithm of up to 7 is right to 7 epsilon, and so is, relatively, its exponential.
    EXPECT_TRUE(variables.ToValues(variables.FromValues(values)).isApprox(values, 10 * kEpsilon));
  }
}

// The exponentials of the logarithms of many numbers are off by a bit, to either side.
TEST(FitVariables, ReachTheBoundsToTheLastBitAndNeverLeaveThem) {
  for (int i = 1; i <= 200; ++i) {
    const FitVariables variables(Lattice({{"a", 0.1 * i, 0.7 * i, 0.1}, {"b", -0.1 * i, 0.2 * i, 0.1}}));
    const Eigen::Vector2d lower(0.1 * i, -0.1 * i);
    const Eigen::Vector2d upper(0.7 * i, 0.2 * i);
    EXPECT_EQ(variables.ToValues(variables.lower()), lower);
    EXPECT_EQ(variables.ToValues(variables.upper()), upper);
    EXPECT_EQ(variables.ToValues(variables.FromValues(lower)), lower);
    EXPECT_EQ(variables.ToValues(variables.FromValues(upper)), upper);
    EXPECT_EQ(variables.ToValues(Eigen::Vector2d(-9, 2)), Eigen::Vector2d(lower[0], upper[1]));
  }
}

TEST(FitVariables, SlopesAreTheDerivativesOfTheValues) {
  const FitVariables variables(ThreeAxes());
  const Eigen::Vector3d values(200, 3, 100);
  const Eigen::VectorXd x = variables.FromValues(values);
  const double h = 1e-6;
  for (Eigen::Index j = 0; j < 3; ++j) {
    const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(3, j);
    const double difference = (variables.ToValues(x + step)[j] - variables.ToValues(x - step)[j]) / (2 * h);
    // Truncation h^2 / 6 is below the rounding epsilon / h of the values.
    EXPECT_NEAR(difference / variables.Slopes(values)[j], 1, 10 * kEpsilon / h);
  }
}

TEST(FitVariables, RefuseAValueOutOfBoundsByName) {
  const FitVariables variables(ThreeAxes());
  EXPECT_THAT([&] { variables.FromValues(Eigen::Vector3d(200, 8.5, 0)); },
              ThrowsMessage<std::invalid_argument>(StrEq("offset = 8.5, must be in [-2, 8]")));
  EXPECT_THAT([&] { variables.FromValues(Eigen::Vector3d(49, 3, 0)); },
              ThrowsMessage<std::invalid_argument>(StrEq("mass = 49, must be in [50, 800]")));
  EXPECT_THAT([&] { variables.FromValues(Eigen::Vector3d(std::nan(""), 3, 0)); },
              ThrowsMessage<std::invalid_argument>(StrEq("mass = nan, must be in [50, 800]")));
  EXPECT_THAT([&] { variables.FromValues(Eigen::Vector2d(200, 3)); },
              ThrowsMessage<std::invalid_argument>(StrEq("number of values = 2, must be 3")));
}

}  // namespace
}  // namespace fourpost::fit_variables_test
