#include "vehicles/laws/spring_law.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/rounding.h"

namespace fourpost::spring_law_test {
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

/// A progressive coil as measured, from the design pose.
SpringLaw MeasuredCoil() {
  SpringLaw law;
  law.curve.emplace(std::vector<double>{-0.06, -0.03, 0.0, 0.03, 0.06},
                    std::vector<double>{-5200, -3300, -2000, -1000, 0});
  return law;
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
  for (const SpringLaw& law : {Coil(), engaged, MeasuredCoil()})
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

TEST(SpringLaw, CurveLeavesItsForceInTheDesignPoseToThePreload) {
  const SpringLaw law = MeasuredCoil();
  EXPECT_EQ(law.Force(0), 0);
  EXPECT_DOUBLE_EQ(law.Force(0.06), 2000);
  EXPECT_DOUBLE_EQ(law.Force(-0.06), -3200);
  // The parabola through the neighbours: mean of the chords 1300 and 1000 N over 30 mm.
  EXPECT_DOUBLE_EQ(law.Slope(0), 2300 / 0.06);
  EXPECT_FALSE(law.IsLinear());
}

TEST(SpringLaw, CurveOnALineIsTheLinearSpring) {
  SpringLaw law;
  law.curve.emplace(std::vector<double>{-0.1, -0.02, 0.05}, std::vector<double>{-2500, -100, 2000});
  for (double x = -0.2; x < 0.2; x += 0.013) {
    // Rounding of some kN.
    EXPECT_NEAR(law.Force(x), 30e3 * x, 1e4 * 16 * kUlp) << x;
    EXPECT_NEAR(law.Energy(x), 15e3 * x * x, 1e4 * 16 * kUlp) << x;
  }
}

// Free play of half a millimetre either way, as urdf/README.md writes it. Its describing function, force in phase over
// amplitude (A. Gelb and W. Vander Velde, Multiple-Input Describing Functions, 1968, table of appendix B):
//   k (1 - 2 / pi (asin(g / A) + g / A sqrt(1 - (g / A)^2)))
TEST(SpringLaw, FreePlayHasItsDescribingFunction) {
  constexpr double kPlay = 0.5e-3;
  constexpr double kRate = 5e6;
  const SpringLaw law{
      .stiffness = 0,
      .knees = {{.at = -kPlay, .side = -1, .stiffness = kRate}, {.at = kPlay, .side = 1, .stiffness = kRate}}};
  EXPECT_EQ(law.Force(0.9 * kPlay), 0);
  // The trapezoidal rule errs by the square of the step at its corners.
  constexpr int kCount = 20000;
  for (const double amplitude : {0.6e-3, 1e-3, 5e-3}) {
    double in_phase = 0;
    for (int i = 0; i < kCount; ++i) {
      const double sine = std::sin(2 * std::numbers::pi * i / kCount);
      in_phase += 2 * law.Force(amplitude * sine) * sine / kCount;
    }
    const double share = kPlay / amplitude;
    const double expected =
        kRate * (1 - 2 / std::numbers::pi * (std::asin(share) + share * std::sqrt(1 - share * share)));
    EXPECT_NEAR(in_phase / amplitude, expected, 1e-6 * kRate) << amplitude;
  }
}

TEST(SpringLaw, IsNanForNan) {
  EXPECT_TRUE(std::isnan(MeasuredCoil().Force(kNan)));
  EXPECT_TRUE(std::isnan(MeasuredCoil().Energy(kNan)));
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
}  // namespace fourpost::spring_law_test
