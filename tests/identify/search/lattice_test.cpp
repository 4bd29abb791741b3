#include "identify/search/lattice.h"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/rounding.h"

namespace fourpost::lattice_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StrEq;
using testing::ThrowsMessage;

Lattice OneAxis(double lower, double upper, double precision) { return Lattice({{"p", lower, upper, precision}}); }

Eigen::VectorXd Vector1(double value) { return Eigen::VectorXd::Constant(1, value); }

// The counts of the thesis, ch. 2; it does not give the ranges.
TEST(Lattice, HasTheCountsOfTheThesisExample) {
  const Lattice lattice({{"k", 0, 5000, 0.1}, {"d", 0, 100, 0.001}, {"m", 50, 550, 0.01}});
  EXPECT_EQ(lattice.count(0), 50001);
  EXPECT_EQ(lattice.count(1), 100001);
  EXPECT_EQ(lattice.count(2), 50001);
}

TEST(Lattice, CountsStepsInSpiteOfRoundedBounds) {
  EXPECT_EQ(OneAxis(0, 0.3, 0.1).count(0), 4);    // 0.3 / 0.1 < 3
  EXPECT_EQ(OneAxis(0.1, 0.7, 0.1).count(0), 7);  // 0.6 / 0.1 < 6
  EXPECT_EQ(OneAxis(0.2, 0.3, 0.1).count(0), 2);  // 0.3 - 0.2 < 0.1
  EXPECT_EQ(OneAxis(-0.3, 0.3, 0.1).count(0), 7);
  EXPECT_EQ(OneAxis(1e6, 1e6 + 0.3, 0.1).count(0), 4);
}

TEST(Lattice, LeavesOutTheUpperBoundWhenTheStepsMissIt) {
  const Lattice lattice = OneAxis(0, 1, 0.3);
  EXPECT_EQ(lattice.count(0), 4);
  EXPECT_DOUBLE_EQ(lattice.Values({4})[0], 0.9);
}

TEST(Lattice, HasTheValuesOfTheThesisFormula) {
  const Lattice lattice({{"mass", 100, 600, 0.25}, {"teeth", 12, 60, 1}});
  EXPECT_EQ(lattice.Values({1, 1}), Eigen::Vector2d(100, 12));
  EXPECT_EQ(lattice.Values({5, 8}), Eigen::Vector2d(101, 19));
  EXPECT_EQ(lattice.Values({2001, 49}), Eigen::Vector2d(600, 60));
}

TEST(Lattice, ReachesBothBoundsAndExceedsNone) {
  // Without care the last value here is 0.30000000000000004.
  const Lattice lattice = OneAxis(0, 0.3, 0.1);
  EXPECT_EQ(lattice.Values({1})[0], 0);
  EXPECT_EQ(lattice.Values({4})[0], 0.3);
}

TEST(Lattice, NearestInvertsValues) {
  const Lattice lattice({{"a", -0.3, 0.7, 0.1}, {"b", 1e-3, 7e-3, 1e-4}, {"c", 12, 60, 1}, {"d", 1e6, 1e6 + 5, 0.1}});
  for (std::int64_t e = 1; e <= 11; ++e) {
    const LatticePoint point = {e, 6 * e - 5, 4 * e, 5 * e - 4};
    EXPECT_EQ(lattice.Nearest(lattice.Values(point)), point);
  }
}

TEST(Lattice, NearestRoundsAndStaysWithinTheBounds) {
  const Lattice lattice = OneAxis(10, 20, 2);
  EXPECT_THAT(lattice.Nearest(Vector1(12.9)), ElementsAre(2));
  EXPECT_THAT(lattice.Nearest(Vector1(13.1)), ElementsAre(3));
  EXPECT_THAT(lattice.Nearest(Vector1(9)), ElementsAre(1));
  EXPECT_THAT(lattice.Nearest(Vector1(21)), ElementsAre(6));
  EXPECT_THAT(lattice.Nearest(Vector1(-kInfinity)), ElementsAre(1));
  EXPECT_THAT(lattice.Nearest(Vector1(kInfinity)), ElementsAre(6));
}

TEST(Lattice, NearestRefusesAWrongSizeAndNan) {
  const Lattice lattice = OneAxis(10, 20, 2);
  EXPECT_THAT([&] { lattice.Nearest(Eigen::Vector2d(10, 10)); },
              ThrowsMessage<std::invalid_argument>(StrEq("expected 1 values, got 2")));
  EXPECT_THAT([&] { lattice.Nearest(Vector1(kNan)); },
              ThrowsMessage<std::invalid_argument>(StrEq("p: the value is not a number")));
}

TEST(Lattice, ContainsItsPointsAndNoOther) {
  const Lattice lattice({{"a", 0, 1, 0.5}, {"b", 0, 1, 0.25}});
  EXPECT_TRUE(lattice.Contains({1, 1}));
  EXPECT_TRUE(lattice.Contains({3, 5}));
  for (const LatticePoint& point : {LatticePoint{0, 1}, {1, 0}, {4, 1}, {1, 6}, {1}, {1, 1, 1}}) {
    EXPECT_FALSE(lattice.Contains(point));
    EXPECT_THROW(lattice.Values(point), std::invalid_argument);
  }
}

TEST(Lattice, DistanceIsTheLargestShareOfARange) {
  const Lattice lattice({{"a", 0, 10, 1}, {"b", 0, 100, 1}});
  EXPECT_EQ(LatticeDistance(lattice, {3, 50}, {3, 50}), 0);
  EXPECT_EQ(LatticeDistance(lattice, {3, 50}, {5, 40}), 0.2);
  EXPECT_EQ(LatticeDistance(lattice, {5, 10}, {3, 50}), 0.4);
  EXPECT_EQ(LatticeDistance(lattice, {1, 1}, {11, 1}), 1);
}

struct FaultCase {
  const char* name;
  LatticeAxis axis;
  const char* fault;
};

std::ostream& operator<<(std::ostream& out, const FaultCase& fault) { return out << fault.name; }

class LatticeFault : public testing::TestWithParam<FaultCase> {};

TEST_P(LatticeFault, IsNamed) {
  EXPECT_THAT(LatticeFaults({GetParam().axis}), ElementsAre(StrEq(GetParam().fault)));
  EXPECT_THAT([] { Lattice lattice({GetParam().axis}); },
              ThrowsMessage<std::invalid_argument>(StrEq(GetParam().fault)));
}

INSTANTIATE_TEST_SUITE_P(
    Lattice, LatticeFault,
    testing::Values(
        FaultCase{"NanBound", {"k", kNan, 1, 0.1}, "k: bounds nan .. 1 are not finite"},
        FaultCase{"InfiniteBound", {"k", 0, kInfinity, 0.1}, "k: bounds 0 .. inf are not finite"},
        FaultCase{"InfiniteRange", {"k", -1e308, 1e308, 0.1}, "k: bounds -1e+308 .. 1e+308 are not finite"},
        FaultCase{"NoRange", {"k", 2, 2, 0.1}, "k: lower and upper bound are both 2; fix the parameter instead"},
        FaultCase{"Swapped", {"k", 3, 2, 0.1}, "k: lower bound 3 is above upper bound 2"},
        FaultCase{"ZeroPrecision", {"k", 0, 1, 0}, "k: precision 0 is not a positive number"},
        FaultCase{"NegativePrecision", {"k", 0, 1, -0.1}, "k: precision -0.1 is not a positive number"},
        FaultCase{"NanPrecision", {"k", 0, 1, kNan}, "k: precision nan is not a positive number"},
        FaultCase{"CoarsePrecision", {"k", 0, 1, 1.5}, "k: precision 1.5 exceeds the range 1"},
        FaultCase{"FinePrecision", {"k", 0, 1, 1e-16}, "k: precision 1e-16 splits the range into more than 2^53 steps"},
        FaultCase{"NoName", {"", 0, 1, 0.1}, "parameter 1: has no name"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Lattice, NamesAllFaultsAtOnce) {
  EXPECT_THAT(
      [] {
        Lattice lattice({{"k", 2, 1, 0.1}, {"m", 0, 1, 0.1}, {"m", 0, 1, 2}});
      },
      ThrowsMessage<std::invalid_argument>(StrEq("k: lower bound 2 is above upper bound 1\n"
                                                 "m: is there twice\n"
                                                 "m: precision 2 exceeds the range 1")));
}

TEST(Lattice, NeedsAParameter) {
  EXPECT_THAT([] { Lattice lattice({}); }, ThrowsMessage<std::invalid_argument>(HasSubstr("no parameter")));
}

TEST(Lattice, HasNoFaultWhenGood) { EXPECT_THAT(LatticeFaults({{"k", 0, 1, 1}}), IsEmpty()); }

TEST(Lattice, RoundsDiscreteValuesOnly) {
  const Lattice lattice({{.name = "teeth", .lower = 12, .upper = 60, .precision = 1, .discrete = true},
                         {.name = "k", .lower = 0, .upper = 10, .precision = 1}});
  EXPECT_EQ(lattice.RoundDiscrete(Eigen::Vector2d(16.4, 3.3)), Eigen::Vector2d(16, 3.3));
  EXPECT_EQ(lattice.RoundDiscrete(Eigen::Vector2d(60.7, 3.3)), Eigen::Vector2d(60, 3.3));
}

}  // namespace
}  // namespace fourpost::lattice_test
