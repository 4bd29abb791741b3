#include "vehicles/laws/spring_law.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/rounding.h"

namespace fourpost {
namespace {

using testing::StrEq;
using testing::ThrowsMessage;

/// A coil that softens in rebound, a progressive stop in compression, another stop in rebound.
SpringLaw Coil() {
  return {.stiffness = 30e3,
          .cubic = 2e6,
          .knees = {{.at = 0.02, .side = 1, .stiffness = -10e3},
                    {.at = -0.05, .side = -1, .stiffness = 5e3, .cubic = 4e8},
                    {.at = 0.06, .side = 1, .stiffness = 200e3}}};
}

TEST(SpringLaw, LinearIsProportional) {
  const SpringLaw law{.stiffness = 30e3};
  EXPECT_EQ(law.Force(0.5), 15e3);
  EXPECT_EQ(law.Slope(-0.5), 30e3);
  EXPECT_EQ(law.Energy(0.5), 3750);
  EXPECT_TRUE(law.IsLinear());
}

TEST(SpringLaw, AddsTheCubeAndWhatLiesBeyondAKnee) {
  const SpringLaw law = Coil();
  EXPECT_EQ(law.Force(0), 0);
  EXPECT_DOUBLE_EQ(law.Force(0.01), 300 + 2);
  EXPECT_DOUBLE_EQ(law.Force(0.03), 900 + 54 - 100);
  EXPECT_DOUBLE_EQ(law.Force(0.07), 2100 + 686 - 500 + 2000);
  EXPECT_DOUBLE_EQ(law.Force(-0.06), -1800 - 432 - 50 - 400);
  EXPECT_FALSE(law.IsLinear());
}

TEST(SpringLaw, SlopeAtAKneeIsTheMeanOfBothSides) {
  EXPECT_DOUBLE_EQ(Coil().Slope(0.02), 30e3 + 3 * 2e6 * 0.02 * 0.02 - 5e3);
  EXPECT_DOUBLE_EQ(Coil().Slope(-0.05), 30e3 + 3 * 2e6 * 0.05 * 0.05 + 2.5e3);
}

TEST(SpringLaw, SlopeIsTheDerivative) {
  const SpringLaw law = Coil();
  constexpr double kStep = 1e-6;
  // Off the knees; truncation 4e8 step^2 from the cube of the stop, rounding of 50 kN over the step.
  for (double x = -0.0995; x < 0.1; x += 0.001)
    EXPECT_NEAR((law.Force(x + kStep) - law.Force(x - kStep)) / (2 * kStep), law.Slope(x),
                5e8 * kStep * kStep + 5e4 * kUlp / kStep)
        << x;
}

/// Simpson's rule, exact for cubics, on a grid that has the knees.
double Quadrature(const SpringLaw& law, int hundredths) {
  double sum = 0;
  const double width = hundredths < 0 ? -0.01 : 0.01;
  for (int i = 0; i < std::abs(hundredths); ++i) {
    const double x = i * width;
    sum += width / 6 * (law.Force(x) + 4 * law.Force(x + width / 2) + law.Force(x + width));
  }
  return sum;
}

TEST(SpringLaw, EnergyIsTheIntegralOfForce) {
  SpringLaw engaged = Coil();
  engaged.knees.push_back({.at = 0.03, .side = -1, .stiffness = 8e3, .cubic = 1e6});
  for (const SpringLaw& law : {Coil(), engaged})
    for (int hundredths = -10; hundredths <= 10; ++hundredths)
      // Rounding of some kN over 0.1 m.
      EXPECT_NEAR(law.Energy(0.01 * hundredths), Quadrature(law, hundredths), 1e4 * 100 * kUlp);
}

TEST(SpringLaw, KneeThatActsInTheDesignPoseLeavesItsForceToThePreload) {
  const SpringLaw law{.stiffness = 30e3, .knees = {{.at = 0.02, .side = -1, .stiffness = 10e3}}};
  EXPECT_EQ(law.Force(0), 0);
  EXPECT_EQ(law.Slope(0), 40e3);
  EXPECT_DOUBLE_EQ(law.Force(-0.01), -400);
  EXPECT_DOUBLE_EQ(law.Force(0.02), 800);
  EXPECT_DOUBLE_EQ(law.Force(0.03), 1100);
}

TEST(SpringLaw, KneesOfNothingLeaveItLinear) {
  EXPECT_TRUE((SpringLaw{.stiffness = 30e3, .knees = {{.at = 0.02}}}.IsLinear()));
}

TEST(SpringLaw, IsNanForNan) {
  EXPECT_TRUE(std::isnan(Coil().Force(kNan)));
  EXPECT_TRUE(std::isnan(Coil().Slope(kNan)));
  EXPECT_TRUE(std::isnan(Coil().Energy(kNan)));
}

void ExpectRefused(const SpringLaw& law, const std::string& message) {
  EXPECT_THAT([&] { law.Validate(); }, ThrowsMessage<std::invalid_argument>(StrEq(message)));
}

TEST(SpringLaw, ValidatesItsNumbers) {
  EXPECT_NO_THROW(Coil().Validate());
  ExpectRefused({.stiffness = kNan}, "SpringLaw: stiffness = nan, must be finite");
  ExpectRefused({.cubic = kNan}, "SpringLaw: cubic = nan, must be finite");
  ExpectRefused({.knees = {{}, {.side = 0}}}, "SpringLaw: knees[1].side = 0, must be +1 or -1");
  ExpectRefused({.knees = {{.at = kNan}}}, "SpringLaw: knees[0].at = nan, must be finite");
  ExpectRefused({.knees = {{.stiffness = kNan}}}, "SpringLaw: knees[0].stiffness = nan, must be finite");
  ExpectRefused({.knees = {{.cubic = kNan}}}, "SpringLaw: knees[0].cubic = nan, must be finite");
}

}  // namespace
}  // namespace fourpost
