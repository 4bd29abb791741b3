#include "vehicles/curves/curve_file.h"

#include <numbers>

#include <gmock/gmock.h>

#include "tests/findings.h"
#include "tests/temporary_folder.h"
#include "tests/vehicles/curves/property_samples.h"
#include "tests/vehicles/fault_case.h"
#include "vehicles/curves/findings.h"

namespace fourpost::curve_file_test {
namespace {

using testing::ElementsAre;

const std::string kSpringTable = R"(extension [mm],force [kN],note
-95.1,-4.4,bound
-60,-2.1,
0,0,
)";

const std::string kDamperTable = R"(# on the bench
speed,force
m/s,N
-0.5,-800
-0.1,-300
0,0
0.1,700
)";

auto IsPoint(double x, double force) {
  return testing::AllOf(testing::Field(&CurvePoint::x, x), testing::Field(&CurvePoint::force, force));
}

int LineOfFirst(const std::string& text, const std::string& part) {
  return static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(part)), '\n')) +
         1;
}

class CurveFile : public testing::Test {
 protected:
  std::optional<SpringCurve> Spring(const std::string& text) {
    return ReadSpringCurve(folder_.Write("curve", text), found_);
  }
  std::optional<std::vector<CurvePoint>> Damper(const std::string& text) {
    return ReadDamperCurve(folder_.Write("curve", text), found_);
  }
  std::optional<std::vector<CurvePoint>> Tyre(const std::string& text) {
    return ReadTyreCurve(folder_.Write("curve", text), found_);
  }
  std::optional<BushingRates> Bushing(const std::string& text) {
    return ReadBushingRates(folder_.Write("curve", text), found_);
  }

  TemporaryFolder folder_;
  Diagnostics found_;
};

TEST_F(CurveFile, ReadsATableOfASpring) {
  const std::optional<SpringCurve> curve = Spring(kSpringTable);
  ASSERT_TRUE(curve) << found_.Format();
  // Powers of ten are exact.
  EXPECT_THAT(curve->points, ElementsAre(IsPoint(-0.0951, -4400), IsPoint(-0.06, -2100), IsPoint(0, 0)));
  EXPECT_FALSE(curve->free_length);
  EXPECT_EQ(curve->points.front().line, 2);
}

TEST_F(CurveFile, TurnsColumnsThatCountTheOtherWay) {
  const std::optional<SpringCurve> curve = Spring("-extension [mm];-force [N]\n0;0\n10,5;100\n20;300\n");
  ASSERT_TRUE(curve) << found_.Format();
  EXPECT_THAT(curve->points, ElementsAre(IsPoint(-0.02, -300), IsPoint(-0.0105, -100), IsPoint(0, 0)));
}

TEST_F(CurveFile, ReadsATableOfADamper) {
  const auto curve = Damper(kDamperTable);
  ASSERT_TRUE(curve) << found_.Format();
  EXPECT_THAT(*curve, ElementsAre(IsPoint(-0.5, -800), IsPoint(-0.1, -300), IsPoint(0, 0), IsPoint(0.1, 700)));
}

// Adams counts a spring's deflection as it shortens, and the force as it pushes.
TEST_F(CurveFile, ReadsAPropertyFileOfASpring) {
  const std::optional<SpringCurve> curve = Spring(kSpringFile);
  ASSERT_TRUE(curve) << found_.Format();
  EXPECT_THAT(curve->points,
              ElementsAre(IsPoint(-0.12, -4200), IsPoint(-0.06, -1800), IsPoint(0, 0), IsPoint(0.05, 1500)));
  EXPECT_EQ(curve->free_length, 0.32);
}

TEST_F(CurveFile, ReadsAPropertyFileOfADamper) {
  const auto curve = Damper(kDamperFile);
  ASSERT_TRUE(curve) << found_.Format();
  EXPECT_THAT(*curve, ElementsAre(IsPoint(-0.5, -800), IsPoint(-0.1, -300), IsPoint(0, 0), IsPoint(0.1, 700),
                                  IsPoint(0.5, 2400)));
}

TEST_F(CurveFile, ReadsThePropertyFileAndTheTableOfATyre) {
  const auto points = testing::ElementsAre(IsPoint(0, 0), IsPoint(0.01, 1900), IsPoint(0.03, 6300));
  const std::optional<std::vector<CurvePoint>> file = Tyre(kTyreFile);
  ASSERT_TRUE(file) << found_.Format();
  EXPECT_THAT(*file, points);
  const std::optional<std::vector<CurvePoint>> table = Tyre("force [kN],deflection [mm]\n0,0\n1.9,10\n6.3,30\n");
  ASSERT_TRUE(table) << found_.Format();
  EXPECT_THAT(*table, points);
}

TEST_F(CurveFile, RefusesTyresThatSoftenToNothing) {
  EXPECT_FALSE(Tyre("force [kN],deflection [mm]\n0,0\n1.9,10\n1.8,30\n"));
  EXPECT_THAT(found_, Reports(kCurveOrder, 4, {"30 mm, 1.8 kN", "10 mm, 1.9 kN"}));
}

TEST_F(CurveFile, HonoursTheUnitsOfAPropertyFile) {
  std::string text = Replace(kDamperFile, "LENGTH  =  'mm'", "length  =  'inch'");
  text = Replace(text, "'newton'", "'pound_force'");
  const auto curve = Damper(text);
  ASSERT_TRUE(curve) << found_.Format();
  EXPECT_DOUBLE_EQ(curve->back().x, 500 * 0.0254);
  EXPECT_DOUBLE_EQ(curve->back().force, 2400 * 0.45359237 * 9.80665);
}

TEST_F(CurveFile, ReadsAPropertyFileOfABushing) {
  const std::optional<BushingRates> rates = Bushing(kBushingFile);
  ASSERT_TRUE(rates) << found_.Format();
  EXPECT_TRUE(found_.items().empty());
  constexpr double kDegree = std::numbers::pi / 180;
  const std::array<double, 6> stiffness = {2e6, 3e6, 0.5e6, 2 / kDegree, 4 / kDegree, 0};
  const std::array<double, 6> damping = {2e3, 3e3, 500, 0.01 / kDegree, 0.02 / kDegree, 0};
  for (std::size_t i = 0; i < 6; ++i) {
    // Of unit conversions.
    EXPECT_NEAR(rates->stiffness[i], stiffness[i], 1e-12 * stiffness[i]) << i;
    EXPECT_NEAR(rates->damping[i], damping[i], 1e-12 * damping[i]) << i;
  }
}

TEST_F(CurveFile, WarnsOfABentCurveOfABushing) {
  const std::string text = Replace(kBushingFile, "   0.0      0.0\n", "  -1.0 -1000.0\n   1.0   1000.0\n");
  const std::optional<BushingRates> rates = Bushing(text);
  ASSERT_TRUE(rates);
  EXPECT_DOUBLE_EQ(rates->stiffness[0], 1e6);
  EXPECT_THAT(found_,
              ReportsOnly(kBushingCurveBent, LineOfFirst(text, "[FX_CURVE]"), {"FX_CURVE", "1000 N/mm", "2000 N/mm"}));
}

TEST_F(CurveFile, TakesABushingWithoutDamping) {
  const std::size_t begin = kBushingFile.find("[DAMPING]");
  std::string text = kBushingFile;
  text.erase(begin, kBushingFile.find("[FX_CURVE]") - begin);
  const std::optional<BushingRates> rates = Bushing(text);
  ASSERT_TRUE(rates) << found_.Format();
  EXPECT_EQ(rates->damping[1], 0);
}

TEST_F(CurveFile, RefusesXml) {
  EXPECT_FALSE(Spring("<?xml version=\"1.0\"?><spring/>"));
  EXPECT_THAT(found_, Reports(kCurveXml));
}

TEST_F(CurveFile, RefusesRecordingsOfManyPoints) {
  std::string text = "speed [m/s],force [N]\n";
  for (int i = 1; i <= 1001; ++i) text += std::to_string(i) + "," + std::to_string(i) + "\n";
  EXPECT_FALSE(Damper(text));
  EXPECT_THAT(found_, ReportsOnly(kCurveTooLong, 1002, {"1001", "1000"}));
}

TEST_F(CurveFile, PassesByAByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_TRUE(Spring(mark + kSpringTable)) << found_.Format();
  EXPECT_TRUE(Spring(mark + kSpringFile)) << found_.Format();
  EXPECT_TRUE(Damper(mark + kDamperFile)) << found_.Format();
  EXPECT_TRUE(Bushing(mark + kBushingFile)) << found_.Format();
}

TEST_F(CurveFile, RefusesLargeFiles) {
  const std::string large = kSpringTable + std::string(1 << 20, '\n');
  EXPECT_FALSE(Spring(large));
  EXPECT_THAT(found_, ReportsOnly(kCurveFileTooLarge, 0, {"1 MiB", "1000"}));
  found_ = {};
  EXPECT_FALSE(Bushing(kBushingFile + std::string(1 << 20, '\n')));
  EXPECT_THAT(found_, ReportsOnly(kCurveFileTooLarge, 0));
}

TEST_F(CurveFile, StopsAfterAHundredFaults) {
  const auto rows = [](const std::string& row) {
    std::string text;
    for (int i = 0; i < 20000; ++i) text += row;
    return text;
  };
  const auto is_short = [&] {
    EXPECT_LE(found_.items().size(), 100U) << found_.items().back().id;
    EXPECT_GE(found_.items().size(), 90U) << found_.Format();
    found_ = {};
  };
  EXPECT_FALSE(Spring(kSpringTable + rows("a,b,c\n")));
  is_short();
  EXPECT_FALSE(Damper(kDamperTable + rows("1,-1\n")));
  is_short();
  EXPECT_FALSE(Spring("[UNITS]\n[UNITS]\n" + rows("[UNITS]\n")));
  is_short();
  EXPECT_FALSE(Damper(Replace(kDamperFile, "[CURVE]", "[CURVE]\n" + rows("1\n"))));
  is_short();
}

TEST_F(CurveFile, ReportsAllFaultsAtOnce) {
  std::string text = Replace(kBushingFile, "'degrees'", "'grad'");
  text = Replace(text, "'newton'", "'stone'");
  EXPECT_FALSE(Bushing(text));
  EXPECT_THAT(found_, Reports(kTeimUnit, LineOfFirst(text, "ANGLE"), {"grad", "degrees"}));
  EXPECT_THAT(found_, Reports(kTeimUnit, LineOfFirst(text, "FORCE"), {"stone", "newton"}));
}

struct CurveFault : FaultCase {
  const std::string& good;
};

class BrokenCurve : public CurveFile, public testing::WithParamInterface<CurveFault> {};

TEST_P(BrokenCurve, IsReported) {
  const CurveFault& fault = GetParam();
  const std::string text = Replace(fault.good, fault.from, fault.to);
  const bool is_spring = &fault.good == &kSpringTable || &fault.good == &kSpringFile;
  const bool reads = &fault.good == &kBushingFile ? Bushing(text).has_value()
                     : is_spring                  ? Spring(text).has_value()
                                                  : Damper(text).has_value();
  EXPECT_FALSE(reads);
  EXPECT_THAT(found_, Reports(fault.kind, fault.at.empty() ? 0 : LineOfFirst(text, fault.at), fault.words));
}

INSTANTIATE_TEST_SUITE_P(
    Each, BrokenCurve,
    testing::Values(
        CurveFault{{"ColumnMisspelt", "extension", "extention", "extention", kCurveColumnMissing, {"extension"}},
                   kSpringTable},
        CurveFault{{"ColumnWithoutUnit", " [mm]", "", "extension", kCurveUnit, {"no unit", "length"}}, kSpringTable},
        CurveFault{{"UnitOfAnother", "[kN]", "[mm]", "force", kCurveUnit, {"'mm'", "force"}}, kSpringTable},
        CurveFault{{"ColumnTwice", "note", "-force [N]", "extension", kCurveColumnTwice, {"-force"}}, kSpringTable},
        CurveFault{{"NoNumber", "-2.1", "much", "-60", kCurveNumber, {"much", "force"}}, kSpringTable},
        CurveFault{{"Falls", "-2.1", "-4.5", "-60", kCurveOrder, {"-60 mm, -4.5 kN", "-95.1 mm, -4.4 kN"}},
                   kSpringTable},
        CurveFault{{"Flat", "-2.1", "-4.4", "-60", kCurveOrder}, kSpringTable},
        CurveFault{{"OnePoint", "-60,-2.1,\n0,0,\n", "", "-95.1", kCurvePoints}, kSpringTable},
        CurveFault{{"Vast", "-4.4", "-4e40", "-95.1", kCurveTooLarge}, kSpringTable},
        CurveFault{{"Pushes", "-0.1,-300", "-0.1,300", "-0.1,", kCurvePushes, {"300 N"}}, kDamperTable},
        CurveFault{{"PushesInMillimetres",
                    "m/s,N\n-0.5,-800\n-0.1,-300",
                    "mm/s,kN\n-500,-0.8\n-100,0.3",
                    "-100,",
                    kCurvePushes,
                    {"-100 mm/s", "0.3 kN"}},
                   kDamperTable},
        CurveFault{{"AtRestInKilonewtons",
                    "m/s,N\n-0.5,-800\n-0.1,-300\n0,0",
                    "m/s,kN\n-0.5,-0.8\n-0.1,-0.3\n0,0.02",
                    "0,0.02",
                    kCurveAtRest,
                    {"0.02 kN"}},
                   kDamperTable},
        CurveFault{{"PushesAlways", "force\n", "-force\n", "-0.5", kCurvePushesAlways}, kDamperTable},
        CurveFault{{"AtRest", "0,0\n", "0,20\n", "0,20", kCurveAtRest, {"20 N"}}, kDamperTable},
        CurveFault{{"OtherType", "'spr'", "'dpr'", " FILE_TYPE", kTeimType, {"dpr", "spr"}}, kSpringFile},
        CurveFault{{"NoCurve", "[CURVE]", "[CURV]", "", kTeimBlockMissing, {"CURVE", "'CURV'"}}, kSpringFile},
        CurveFault{{"CurveTwice", "[SPRING_DATA]", "[CURVE]\n[SPRING_DATA]\n", "[CURVE]\n{", kTeimBlockTwice},
                   kSpringFile},
        CurveFault{{"NoLength", " LENGTH  =  'mm'\n", "", "[UNITS]", kTeimValueMissing, {"LENGTH"}}, kSpringFile},
        CurveFault{{"LengthUnknown", "'mm'", "'furlong'", " LENGTH", kTeimUnit, {"furlong"}}, kSpringFile},
        CurveFault{{"FreeLengthNoNumber", "320.0", "long", " FREE_LENGTH", kTeimValue, {"long"}}, kSpringFile},
        CurveFault{{"FreeLengthNegative", "320.0", "-320.0", " FREE_LENGTH", kTeimFreeLength}, kSpringFile},
        CurveFault{{"RowOfOneNumber", "1800.0", "", "     60.0", kTeimRow, {"60.0"}}, kSpringFile},
        CurveFault{{"RowOfThreeNumbers", "1800.0", "1800.0 2", "     60.0", kTeimRow}, kSpringFile},
        CurveFault{{"FallsInAdams", "1800.0", "-1800.0", "      0.0", kCurveOrder}, kSpringFile},
        CurveFault{{"PushesInAdams", "-300.0", "300.0", "   -100.0", kCurvePushes, {"-100 mm/s", "300 N"}},
                   kDamperFile},
        CurveFault{{"BushingOneSided", "  -2.0  -6000.0\n", "   1.0  3000.0\n", "[FY_CURVE]", kBushingCurveZero},
                   kBushingFile},
        CurveFault{{"BushingNoDamping", " FY_DAMPING  =  3.0\n", "", "[DAMPING]", kTeimValueMissing, {"FY_DAMPING"}},
                   kBushingFile},
        CurveFault{
            {"BushingDampingNegative", " FY_DAMPING  =  3.0", " FY_DAMPING  =  -3.0", " FY_DAMPING", kBushingDamping},
            kBushingFile},
        CurveFault{{"BushingCurveMissing", "[TY_CURVE]", "[TYCURVE]", "", kTeimBlockMissing, {"TY_CURVE"}},
                   kBushingFile}),
    [](const testing::TestParamInfo<CurveFault>& each) { return each.param.name; });

}  // namespace
}  // namespace fourpost::curve_file_test
