// One fault at a time in the elements of a car that has them all.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/fault_case.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/reader/findings.h"
#include "vehicles/tags/findings.h"

namespace fourpost::element_faults_test {
namespace {

class ElementFaults : public VehicleFileTest, public ::testing::WithParamInterface<FaultCase> {
 protected:
  /// Forgets that a parameter is used no more where a fault stands in its place.
  void ForgetUnused() {
    const Diagnostics found = std::exchange(diagnostics_, {});
    for (const Diagnostic& item : found.items())
      if (item.id != kParameterUnused.id()) diagnostics_.Add(item);
  }
};

TEST_P(ElementFaults, AreToldWithTheirLine) {
  const FaultCase& fault = GetParam();
  const std::string text = Replaced(kElementCar, fault.from, fault.to);
  EXPECT_FALSE(Read(text).has_value());
  ForgetUnused();
  Expect(LineOf(text, fault.at), fault.kind, fault.words);
}

/// A parameter with bounds in place of one without.
FaultCase Bounded(const std::string& name, const std::string& parameter, const std::string& bounds,
                  const std::string& at, const Finding& kind, const std::vector<std::string>& words = {}) {
  const std::string tag = "<fp:parameter name=\"" + parameter + "\"";
  return {name, tag, "<fp:parameter " + bounds + " name=\"" + parameter + "\"", at, kind, words};
}

const std::string kSlowPoint = R"(<point speed="-$v_table" force="-$f_table"/>)";

/// Of the tyre 'fr'.
const std::string kTyreRate = R"(stiffness="$kt" radius="0.35 m" lateral="$k_side"/>)";

std::string TyreTable(const std::string& attributes, const std::string& points) {
  return attributes + R"(radius="0.35 m" lateral="$k_side"><table>)" + points + "</table></fp:tyre>";
}

const std::string kCubic = R"(<cubic stiffness="$k_fr" cubic="$k3_fr"/>)";

INSTANTIATE_TEST_SUITE_P(
    Springs, ElementFaults,
    ::testing::Values(
        FaultCase{"SpringTableOfOnePoint", kCubic, R"(<table><point extension="0 mm" force="0 N"/></table>)",
                  "<table><point extension", kSpringTablePoints},
        FaultCase{"SpringTableThatFalls",
                  kCubic,
                  "<table><point extension=\"0 mm\" force=\"0 N\"/>\n<point extension=\"9 mm\" "
                  "force=\"-1 N\"/></table>",
                  R"(<point extension="9 mm")",
                  kSpringPointOrder,
                  {"9 mm"}},
        FaultCase{"NoKnee", R"(<knee at="$at_bump" stiffness="$k_bump"/>
      <knee at="$at_rebound" stiffness="$k_rebound"/>)",
                  "", "<multirate", kKneeNone},
        FaultCase{"KneeAtZero",
                  R"(at="$at_bump")",
                  R"(at="0 mm")",
                  R"(at="0 mm")",
                  kKneeOrder,
                  {R"(at="0 mm" of <knee>)", "fp:spring 'fl'"}},
        FaultCase{"KneesOutOfOrder", R"(<knee at="$at_bump")",
                  R"(<knee at="-50 mm" stiffness="1 N/mm"/><knee at="$at_bump")", "<knee", kKneeOrder},
        Bounded("KneeCrossesZero", "at_rebound", R"(lower="-1 mm" upper="40 mm" precision="1 mm")",
                R"(<knee at="$at_rebound")", kKneeOrder),
        FaultCase{"KneeWithoutRate",
                  R"(<knee at="$at_bump" stiffness="$k_bump"/>)",
                  R"(<knee at="$at_bump"/>)",
                  R"(<knee at="$at_bump")",
                  kAttributeMissing,
                  {"'stiffness'"}},
        FaultCase{"NegativeCubic", R"(name="k3_fr" value="400 kN/m^3")", R"(name="k3_fr" value="-400 kN/m^3")",
                  R"(cubic="$k3_fr")", kNumberNegative},
        FaultCase{"CubicOfOtherDimension", R"(cubic="$k3_fr")", R"(cubic="$k_fr")", R"(cubic="$k_fr")",
                  kParameterOfOtherDimension},
        FaultCase{"PreloadAndFreeLength", R"(free_length="$l_rr")", R"(free_length="$l_rr" preload="1 kN")",
                  R"(free_length="$l_rr")", kPreloadAndFreeLength},
        FaultCase{"EquilibriumAndFreeLength", R"(free_length="$l_rr")", R"(free_length="$l_rr" preload="equilibrium")",
                  R"(free_length="$l_rr")", kPreloadAndFreeLength},
        FaultCase{"GuidedFreeLength", R"(<fp:spring name="rr" parent="top_rr" child="seat_rr">)",
                  R"(<fp:spring name="rr" parent="top_rr" child="seat_rr" axis="0 0 1">)", R"(free_length="$l_rr")",
                  kFreeLengthGuided},
        FaultCase{"ZeroFreeLength", R"(name="l_rr" value="0.33 m")", R"(name="l_rr" value="0 m")",
                  R"(free_length="$l_rr")", kNumberNotPositive},
        FaultCase{"EmptyStop", R"(axis="0 0 1"><bump gap="$gap_bump" stiffness="$k_stop"/></fp:stop>)",
                  R"(axis="0 0 1"></fp:stop>)", R"(<fp:stop name="rr")", kStopEmpty},
        FaultCase{"NegativeGap",
                  R"(name="gap_rebound" value="16 mm")",
                  R"(name="gap_rebound" value="-16 mm")",
                  R"(<rebound)",
                  kNumberNegative,
                  {R"(gap="$gap_rebound" of <rebound>)", "fp:stop 'rl'"}},
        FaultCase{"StopWithoutGap",
                  R"(<rebound gap="$gap_rebound" )",
                  "<rebound ",
                  "<rebound",
                  kAttributeMissing,
                  {"'gap'"}}),
    CaseName);

INSTANTIATE_TEST_SUITE_P(
    Dampers, ElementFaults,
    ::testing::Values(
        FaultCase{"NoTransition", R"( speed="$v_smooth")", "", "<smooth", kAttributeMissing, {"'speed'"}},
        FaultCase{"ZeroTransition", R"(name="v_smooth" value="0.05 m/s")", R"(name="v_smooth" value="0 m/s")",
                  "<smooth", kNumberNotPositive},
        FaultCase{"ZeroKneeSpeed", R"(name="v_bump" value="0.06 m/s")", R"(name="v_bump" value="0 m/s")",
                  R"(bump_knee="$v_bump")", kNumberNotPositive},
        FaultCase{"FlatBeyondTheKnee",
                  R"(rebound_beyond="2*$c_beyond")",
                  R"(rebound_beyond="0 N*s/m")",
                  R"(<series stiffness="$k_mount" cubic)",
                  kSeriesWithoutRate,
                  {"fp:damper 'fr'"}},
        Bounded("FlatWithinBounds", "c_beyond", R"(lower="0 N*s/m" upper="1 kN*s/m" precision="1 N*s/m")",
                R"(<series stiffness="$k_mount" cubic)", kSeriesWithoutRate),
        FaultCase{"SaturatingInSeries", R"(<smooth bump="$c_bump" rebound="$c_rebound" speed="$v_smooth"/>)",
                  R"(<saturating bump="$c_bump" rebound="$c_rebound" bump_speed="1 m/s" rebound_speed="1 m/s"/>)",
                  R"(<series stiffness="$k_mount"/>)", kSeriesSaturates},
        FaultCase{"SmoothLawThatFalls", R"(bump="$c_bump" rebound="$c_rebound" speed)",
                  R"(bump="0.05*$c_bump" rebound="$c_rebound" speed)", R"(<series stiffness="$k_mount"/>)",
                  kSeriesNotRising},
        Bounded("SmoothLawThatFallsWithinBounds", "c_rebound",
                R"(lower="2 kN*s/m" upper="14 kN*s/m" precision="1 N*s/m")", R"(<series stiffness="$k_mount"/>)",
                kSeriesNotRising),
        FaultCase{"NoPoints",
                  R"(<point speed="-4*$v_table" force="-2*$f_table"/><point speed="-$v_table" force="-$f_table"/>
      <point speed="$v_table" force="2*$f_table"/><point speed="5*$v_table" force="4*$f_table"/>)",
                  R"(<point speed="$v_table" force="$f_table"/>)", "<table>", kTablePoints},
        FaultCase{"PointThatPushes", kSlowPoint, "\n<point speed=\"-$v_table\" force=\"0.1*$f_table\"/>",
                  R"(<point speed="-$v_table")", kPointSign},
        FaultCase{"PointThatPushesAtRest", kSlowPoint, "\n<point speed=\"0 m/s\" force=\"20 N\"/>",
                  R"(<point speed="0 m/s")", kPointSign},
        FaultCase{"PointsOutOfOrder", kSlowPoint, "\n<point speed=\"-5*$v_table\" force=\"-$f_table\"/>",
                  R"(<point speed="-5*)", kPointOrder},
        FaultCase{"PointsOfOneForce", kSlowPoint, "\n<point speed=\"-$v_table\" force=\"-2*$f_table\"/>",
                  R"(<point speed="-$v)", kPointOrder},
        FaultCase{"FrictionWithoutSpeed", R"(name="v_friction" value="3 mm/s")", R"(name="v_friction" value="0 mm/s")",
                  R"(<friction force="$f_friction" speed)", kNumberNotPositive},
        FaultCase{"FrictionOfTwoLaws",
                  R"(<friction force="$f_friction"/>)",
                  R"(<friction force="$f_friction" speed="3 mm/s" stiffness="200 N/mm"/>)",
                  R"(speed="3 mm/s" stiffness)",
                  kFrictionSpeedAndStiffness,
                  {"fp:damper 'rl'"}},
        FaultCase{"FrictionWithoutStiffness", R"(<friction force="$f_friction"/>)",
                  R"(<friction force="$f_friction" stiffness="0 N/mm"/>)", R"(stiffness="0 N/mm")", kNumberNotPositive},
        FaultCase{"FrictionStiffnessOfOtherDimension", R"(<friction force="$f_friction"/>)",
                  R"(<friction force="$f_friction" stiffness="60 N"/>)", R"(stiffness="60 N")",
                  kNumberOfOtherDimension},
        FaultCase{"FrictionThatSticksInSeries",
                  R"(<friction force="$f_friction" speed="$v_friction"/>)",
                  R"(<friction force="$f_friction" stiffness="200 N/mm"/>)",
                  R"(stiffness="200 N/mm")",
                  kFrictionStiffnessSeries,
                  {"fp:damper 'fr'"}},
        FaultCase{"NegativeGas", R"(name="f_gas" value="120 N")", R"(name="f_gas" value="-120 N")", "<gas",
                  kNumberNegative},
        FaultCase{"ThickRod",
                  R"(name="rod" value="12 mm")",
                  R"(name="rod" value="30 mm")",
                  R"(rod="$rod")",
                  kRodThickness,
                  {R"(rod="$rod" of <hydraulic>)", "fp:damper 'rr'", "$bore"}},
        Bounded("ThickRodWithinBounds", "rod", R"(lower="10 mm" upper="31 mm" precision="1 mm")", R"(rod="$rod")",
                kRodThickness),
        FaultCase{"GasThatCavitates",
                  R"(name="p_gas" value="2 MPa")",
                  R"(name="p_gas" value="5 kPa")",
                  R"(gas_pressure="$p_gas")",
                  kGasPressure,
                  {R"(gas_pressure="$p_gas" of <hydraulic>)", "fp:damper 'rr'", "5 kPa"}},
        FaultCase{"HighCavitation",
                  R"(<hydraulic bleed="$bleed" rebound_valve="2*$valve"/>)",
                  R"(<hydraulic bleed="$bleed" rebound_valve="2*$valve" cavitation="20 bar"/>)",
                  "cavitation=\"20 bar",
                  kGasPressure,
                  {"20 bar"}},
        FaultCase{"NoDensity", R"(<hydraulic bleed="$bleed" rebound_valve="2*$valve"/>)",
                  R"(<hydraulic bleed="$bleed" rebound_valve="2*$valve" density="0 kg/m^3"/>)", "density=\"0 kg",
                  kNumberNotPositive},
        Bounded("GasThatCavitatesWithinBounds", "p_gas", R"(lower="1 kPa" upper="3 MPa" precision="1 kPa")",
                R"(gas_pressure="$p_gas")", kGasPressure),
        FaultCase{"NoBleed", R"(<hydraulic bleed="$bleed" rebound_valve="2*$valve"/>)",
                  R"(<hydraulic bleed="0 mm^2" rebound_valve="2*$valve"/>)", "<hydraulic bleed=\"0",
                  kNumberNotPositive},
        FaultCase{"FaultyParameterOfALaw", R"(name="v_smooth" value="0.05 m/s")", R"(name="v_smooth" value="fast")",
                  R"(name="v_smooth")", kNotAQuantity}),
    CaseName);

INSTANTIATE_TEST_SUITE_P(
    Bushings, ElementFaults,
    ::testing::Values(
        FaultCase{"NothingInIt",
                  R"(<translation x="0.1*$k_x" y="0.1*$k_y"/>
    <rotation x="$kr"/>)",
                  "",
                  R"(<fp:bushing name="hanger")",
                  kBushingResistsNothing,
                  {"fp:bushing 'hanger'"}},
        FaultCase{"OtherPreload", R"(child="foot_left" preload="equilibrium")", R"(child="foot_left" preload="100 N")",
                  R"(child="foot_left")", kUnknownChoice},
        FaultCase{"StiffnessOfOtherDimension", R"(<translation x="0.1*$k_x" y="0.1*$k_y"/>)",
                  R"(<translation x="0.1*$kr" y="0.1*$k_y"/>)", R"(x="0.1*$kr")", kParameterOfOtherDimension},
        FaultCase{"RotationOfOtherDimension", R"(<rotation x="$kr"/>)", R"(<rotation x="$k_x"/>)",
                  R"(<rotation x="$k_x")", kParameterOfOtherDimension},
        FaultCase{"ParameterOfAFrequency",
                  R"(<loss factor="$loss" frequency="12 Hz"/>)",
                  R"(<loss factor="$loss" frequency="$f_loss"/></fp:bushing>
  <fp:parameter name="f_loss" value="12 Hz" source="test"/><fp:bushing name="none" parent="mount_left" child="foot_left">
    <rotation x="1 N*m/rad"/>)",
                  "<loss",
                  kConstantFollows,
                  {R"(frequency="$f_loss" of <loss>)", "fp:bushing 'left'"}},
        FaultCase{"ZeroFrequency", R"(frequency="12 Hz")", R"(frequency="0 Hz")", "<loss", kNumberNotPositive},
        FaultCase{"NegativeLoss", R"(name="loss" value="0.2")", R"(name="loss" value="-0.2")", "<loss",
                  kNumberNegative},
        FaultCase{"TurnOfTwoNumbers", R"(rpy="0 0.7 0")", R"(rpy="0 0.7")", R"(rpy="0 0.7")", kNotAVector},
        FaultCase{"BushingWithBothEndsOnALink",
                  R"(parent="hanger" child="tail")",
                  R"(parent="hanger" child="hook")",
                  R"(<fp:bushing name="hanger")",
                  kClosureOnOneLink,
                  {"link 'chassis'"}},
        FaultCase{"NoRightLine", R"(<right parent="bar_right" child="drop_right" axis="0 0 1"/>)", "", "<fp:antiroll",
                  kTagMissing},
        FaultCase{"LineOnOneLink", R"(<left parent="bar_left" child="drop_left"/>)",
                  R"(<left parent="bar_left" child="bar_right"/>)", "<left", kLineOnOneLink},
        FaultCase{"LineWithoutLength",
                  R"(<fp:frame name="bar_left" link="chassis" xyz="1.1 0.45 0"/>)",
                  R"(<fp:frame name="bar_left" link="chassis" xyz="1.1 0.48 -0.2"/>)",
                  "<fp:antiroll",
                  kLineWithoutLength,
                  {"fp:antiroll 'front'"}},
        FaultCase{"BarWithoutStiffness",
                  R"(name="front" stiffness="$k_bar")",
                  R"(name="front" )",
                  "<fp:antiroll",
                  kAttributeMissing,
                  {"'stiffness'"}}),
    CaseName);

INSTANTIATE_TEST_SUITE_P(
    TyreRates, ElementFaults,
    ::testing::Values(
        FaultCase{"TyreWithoutStiffness",
                  kTyreRate,
                  R"(radius="0.35 m" lateral="$k_side"/>)",
                  R"(<fp:tyre name="fr")",
                  kTyreRateNone,
                  {"'fr'"}},
        FaultCase{"ProgressionOfNoStiffness", kTyreRate,
                  R"(stiffness="0 N/m" progression="3 1/m" radius="0.35 m" lateral="$k_side"/>)",
                  R"(<fp:tyre name="fr")", kTyreRateNone},
        FaultCase{"TyreStiffnessAndTable",
                  kTyreRate,
                  TyreTable(R"(stiffness="$kt" )",
                            R"(<point deflection="0 mm" force="0 N"/><point deflection="9 mm" force="2 kN"/>)"),
                  R"(<fp:tyre name="fr")",
                  kTyreRateTwice,
                  {R"(stiffness="$kt")", "'fr'"}},
        FaultCase{"TyreProgressionAndTable",
                  kTyreRate,
                  TyreTable(R"(progression="3 1/m" )",
                            R"(<point deflection="0 mm" force="0 N"/><point deflection="9 mm" force="2 kN"/>)"),
                  R"(<fp:tyre name="fr")",
                  kTyreRateTwice,
                  {R"(progression="3 1/m")"}},
        FaultCase{"ProgressiveTyreThatPulls",
                  kTyreRate,
                  R"(stiffness="$kt" progression="3 1/m" liftoff="false" radius="0.35 m" lateral="$k_side"/>)",
                  R"(<fp:tyre name="fr")",
                  kTyreHeld,
                  {"'fr'"}},
        FaultCase{"TyreTableOfOnePoint", kTyreRate, TyreTable("", R"(<point deflection="9 mm" force="2 kN"/>)"),
                  R"(<fp:tyre name="fr")", kTyreTablePoints},
        FaultCase{"TyreTableThatFalls",
                  kTyreRate,
                  TyreTable("", R"(<point deflection="0 mm" force="2 kN"/>
<point deflection="9 mm" force="1 kN"/>)"),
                  R"(<point deflection="9 mm")",
                  kTyrePointOrder,
                  {"9 mm"}},
        FaultCase{"TyreThatPullsInItsTable", kTyreRate, TyreTable("", R"(<point deflection="0 mm" force="-2 kN"/>
<point deflection="9 mm" force="1 kN"/>)"),
                  R"(<fp:tyre name="fr")", kNumberNegative}),
    CaseName);

INSTANTIATE_TEST_SUITE_P(
    Tyres, ElementFaults,
    ::testing::Values(FaultCase{"NegativeRadius", R"(stiffness="$kt" radius="0.35 m")",
                                R"(stiffness="$kt" radius="-0.35 m")", R"(<fp:tyre name="fr")", kNumberNegative},
                      FaultCase{"ParameterOfARadius",
                                R"(stiffness="$kt" radius="0.35 m")",
                                R"(stiffness="$kt" radius="$l_rr")",
                                R"(<fp:tyre name="fr")",
                                kConstantFollows,
                                {R"(radius="$l_rr" of fp:tyre)", "'fr'"}},
                      FaultCase{"NeitherLiftsNorNot", R"(stiffness="$kt" radius="0.35 m")",
                                R"(stiffness="$kt" liftoff="yes" radius="0.35 m")", R"(<fp:tyre name="fr")",
                                kUnknownChoice},
                      FaultCase{"LateralOfOtherDimension", R"(stiffness="$kt" radius="0.35 m" lateral="$k_side")",
                                R"(stiffness="$kt" radius="0.35 m" lateral="$ct")", R"(<fp:tyre name="fr")",
                                kParameterOfOtherDimension},
                      FaultCase{"WheelOnItsSide",
                                R"(<origin xyz="-1.3 0.7 0.35"/>)",
                                R"(<origin xyz="-1.3 0.7 0.35" rpy="1.6 0 0"/>)",
                                R"(<fp:tyre name="rl")",
                                kWheelAxis,
                                {"link 'hub'"}},
                      FaultCase{"WheelThatRollsSideways", R"(<origin xyz="-1.3 0.7 0.35"/>)",
                                R"(<origin xyz="-1.3 0.7 0.35" rpy="0 0 1.6"/>)", R"(<fp:tyre name="rl")", kWheelAxis},
                      FaultCase{"WheelpanOfOtherDimension", R"(wheelpan="0.5*$m_pan")", R"(wheelpan="0.5*$kt")",
                                R"(name="F_rl")", kParameterOfOtherDimension},
                      FaultCase{"NegativeWheelpan", R"(wheelpan="0.5*$m_pan")", R"(wheelpan="-1 kg")", R"(name="F_rl")",
                                kNumberNegative},
                      FaultCase{"GyroWithoutAxis",
                                R"( link="engine" axis="0.3 1 0.1")",
                                R"( link="engine")",
                                R"(name="pitch")",
                                kAttributeMissing,
                                {"'axis'"}},
                      FaultCase{"GyroAtAPoint",
                                R"( link="engine" axis="0.3 1 0.1")",
                                R"( link="engine" axis="0 1 0" xyz="0 0 0")",
                                R"(name="pitch")",
                                kAttributeUnknown,
                                {"'xyz'"}},
                      FaultCase{"GyroOfNoLink",
                                R"( link="engine" axis="0.3 1 0.1")",
                                R"( link="motor" axis="0 1 0")",
                                R"(name="pitch")",
                                kReferenceUnknown,
                                {"link 'motor'"}}),
    CaseName);

INSTANTIATE_TEST_SUITE_P(
    Loops, ElementFaults,
    ::testing::Values(
        FaultCase{"HingeWithoutAxis", R"( axis="0.2 1 0.05")", "", "<fp:hinge", kAttributeMissing, {"'axis'"}},
        FaultCase{"HingeOfZeroAxis", R"( axis="0.2 1 0.05")", R"( axis="0 0 0")", "<fp:hinge", kZeroDirection},
        FaultCase{"HingeWithBothEndsOnALink",
                  R"(parent="pivot" child="hinged" axis)",
                  R"(parent="pivot" child="chassis" axis)",
                  "<fp:hinge",
                  kClosureOnOneLink,
                  {"link 'chassis'"}},
        FaultCase{"WeldWithBothEndsOnALink",
                  R"(parent="arm_end" child="hub")",
                  R"(parent="arm_end" child="arm")",
                  "<fp:weld",
                  kClosureOnOneLink,
                  {"fp:weld 'wheel'", "link 'arm'"}},
        FaultCase{"WeldToNothing",
                  R"(parent="arm_end" child="hub")",
                  R"(parent="arm_end" child="hubb")",
                  "<fp:weld",
                  kReferenceUnknown,
                  {"link 'hubb'", "'hub'"}},
        FaultCase{"WeldTwice", R"(<fp:weld name="wheel" parent="arm_end" child="hub"/>)",
                  "<fp:weld name=\"wheel\" parent=\"arm_end\" child=\"hub\"/>\n<fp:weld  name=\"wheel\" "
                  "parent=\"arm_end\" child=\"hub\"/>",
                  "<fp:weld  name", kNameTaken}),
    CaseName);

class ElementReader : public VehicleFileTest {
 protected:
  /// The car of all elements with a parameter given bounds, and another text in it.
  std::string Bounded(const std::string& parameter, const std::string& bounds) {
    const std::string tag = "<fp:parameter name=\"" + parameter + "\"";
    return Replaced(kElementCar, tag, tag + " " + bounds);
  }
};

// Least and greatest values cannot meet where one parameter moves both.
TEST_F(ElementReader, LetsOneParameterScaleACurve) {
  EXPECT_TRUE(Read(Bounded("f_table", R"(lower="50 N" upper="400 N" precision="1 N")")).has_value());
  EXPECT_TRUE(Read(Bounded("v_table", R"(lower="0.02 m/s" upper="0.4 m/s" precision="1 mm/s")")).has_value());
}

TEST_F(ElementReader, LetsOneParameterMoveAllKnees) {
  const std::string text = Bounded("at_bump", R"(lower="-90 mm" upper="-20 mm" precision="1 mm")");
  EXPECT_TRUE(Read(Replaced(text, R"(<knee at="$at_rebound")", R"(<knee at="2*$at_bump" stiffness="90 N/mm"/>
      <knee at="$at_rebound")"))
                  .has_value());
}

TEST_F(ElementReader, LetsOneParameterScaleADampersBore) {
  const std::string text = Bounded("bore", R"(lower="20 mm" upper="50 mm" precision="1 mm")");
  EXPECT_TRUE(Read(Replaced(Replaced(text, R"(rod="$rod")", R"(rod="0.5*$bore")"),
                            R"(<fp:parameter name="rod" value="12 mm" source="test"/>)", ""))
                  .has_value());
}

TEST_F(ElementReader, RefusesAForceThatTurnsItsSignWithinBounds) {
  const std::string text = Replaced(
      Replaced(kElementCar, kSlowPoint, "\n<point speed=\"-$v_table\" force=\"$f_slow\"/>"), "<fp:damper name=\"rl\"",
      R"(<fp:parameter name="f_slow" value="-150 N" lower="-200 N" upper="1 N" precision="1 N" source="test"/>
  <fp:damper name="rl")");
  EXPECT_FALSE(Read(text).has_value());
  Expect(LineOf(text, R"(<point speed="-$v_table")"), kPointSign);
}

TEST_F(ElementReader, TakesAFreeLengthWithEveryLaw) {
  for (const char* law : {"<multirate stiffness=\"$k_fl\"", "<cubic stiffness=\"$k_fr\""}) {
    const std::optional<Vehicle> vehicle =
        Read(Replaced(kElementCar, law, law + std::string(" free_length=\"0.3 m\"")));
    ASSERT_TRUE(vehicle.has_value());
    const auto is_given = [](const Spring& spring) { return spring.free_length && spring.free_length->value == 0.3; };
    EXPECT_EQ(std::count_if(vehicle->springs.begin(), vehicle->springs.end(), is_given), 1) << law;
  }
}

const std::string kHelper = R"(child="ground"><linear stiffness="$k"/></fp:spring>)";

TEST_F(ElementReader, ReadsAMeasuredSpring) {
  const std::optional<Vehicle> vehicle = Read(Replaced(kSmallVehicle, kHelper, R"(child="ground"><table at="-50 mm">
    <point extension="-100 mm" force="-3 kN"/><point extension="-50 mm" force="-1 kN"/>
    <point extension="0 mm" force="0 N"/></table></fp:spring>)"));
  ASSERT_TRUE(vehicle.has_value());
  const SpringLaw law = vehicle->springs.at(1).law.At(vehicle->ParameterValues());
  EXPECT_EQ(law.Force(0), 0);
  EXPECT_DOUBLE_EQ(law.Force(0.05), 1000);
  EXPECT_DOUBLE_EQ(law.Force(-0.05), -2000);
}

TEST_F(ElementReader, WarnsOfADesignPoseBeyondTheTableOfItsSpring) {
  const std::string text = Replaced(kSmallVehicle, kHelper, R"(child="ground"><table at="50 mm">
    <point extension="-100 mm" force="-3 kN"/><point extension="0 mm" force="0 N"/></table></fp:spring>)");
  EXPECT_TRUE(Read(text).has_value());
  Expect(LineOf(text, "at=\"50 mm"), kSpringTablePlace, {"at=\"50 mm\""});
}

TEST_F(ElementReader, ReadsASaturatingDamper) {
  const std::optional<Vehicle> vehicle = Read(
      Replaced(kSmallVehicle, R"(<linear rate="10 N*s/m"/>)",
               R"(<saturating bump="1 kN*s/m" rebound="2 kN*s/m" bump_speed="0.5 m/s" rebound_speed="0.25 m/s"/>)"));
  ASSERT_TRUE(vehicle.has_value());
  const DashpotLaw law = vehicle->dampers.at(1).law.At(vehicle->ParameterValues());
  EXPECT_DOUBLE_EQ(law.Force(0.25), 250);
  EXPECT_DOUBLE_EQ(law.Force(-0.5), -250);
}

TEST_F(ElementReader, TakesAPointAtTheOrigin) {
  EXPECT_TRUE(Read(Replaced(kElementCar, kSlowPoint, R"(<point speed="0 m/s" force="0 N"/>)")).has_value());
}

// Where the default of a missing element stands.
TEST_F(ElementReader, HasTheDefaultsOfTheReference) {
  const std::optional<Vehicle> vehicle = Read(kElementCar);
  ASSERT_TRUE(vehicle.has_value());
  const Damper& top = vehicle->dampers.at(4);
  ASSERT_EQ(top.name, "top");
  ASSERT_TRUE(top.hydraulic.has_value());
  EXPECT_EQ(top.hydraulic->compression_valve.value, 2.597e6);
  EXPECT_EQ(top.hydraulic->bulk_modulus.value, 300e6);
  EXPECT_EQ(top.hydraulic->piston_diameter.value, 0.03);
  EXPECT_EQ(top.hydraulic->rod_diameter.value, 0.0125);
  EXPECT_EQ(top.hydraulic->rebound_column.value, 0.1);
  EXPECT_EQ(top.hydraulic->compression_column.value, 0.1);
  EXPECT_EQ(top.hydraulic->gas_exponent.value, HydraulicDamper().gas_exponent);
  EXPECT_EQ(top.hydraulic->density.value, HydraulicDamper().density);
  EXPECT_EQ(top.hydraulic->cavitation.value, HydraulicDamper().cavitation_pressure);
  EXPECT_EQ(top.hydraulic->gas_pressure.value, 2e6);
  EXPECT_EQ(top.hydraulic->gas_volume.value, 60e-6);
  EXPECT_EQ(top.HydraulicAt(vehicle->ParameterValues()).friction, 0);
  const Tyre& rear = vehicle->tyres.at(2);
  EXPECT_EQ(rear.longitudinal.value, 0);
  EXPECT_TRUE(rear.lifts_off);
  EXPECT_EQ(vehicle->bushings.at(3).stiffness[2].value, 0);
  EXPECT_FALSE(vehicle->bushings.at(3).holds);
  EXPECT_EQ(vehicle->dampers.at(2).law.friction->speed.value, 0.002);
}

TEST_F(ElementReader, ReadsFrictionThatSticksBesideOilAndItsMount) {
  std::string text = kElementCar;
  const std::string_view top = R"(<hydraulic bleed="$bleed" rebound_valve="2*$valve"/>)";
  text.insert(text.find(top) + top.size(), R"(<friction force="$f_seal" stiffness="200 N/mm"/>)");
  const std::optional<Vehicle> vehicle = Read(text);
  ASSERT_TRUE(vehicle.has_value());
  const std::vector<double> values = vehicle->ParameterValues();
  const Damper& damper = vehicle->dampers.at(4);
  EXPECT_EQ(damper.law.StickingAt(values), (DahlFriction{.force = 50, .stiffness = 2e5}));
  EXPECT_EQ(damper.HydraulicAt(values).friction, 0);
  EXPECT_EQ(vehicle->dampers.at(3).law.StickingAt(values), std::nullopt);
}

TEST_F(ElementReader, ReadsWhatAnElementIsMadeOf) {
  const std::optional<Vehicle> read = Read(kElementCar);
  ASSERT_TRUE(read.has_value());
  const Vehicle& car = *read;
  const std::vector<double> values = car.ParameterValues();
  const SpringLaw multirate = car.springs.at(0).law.At(values);
  // 30 N/mm, 50 N/mm beyond -40 mm, 20 N/mm beyond 30 mm.
  EXPECT_DOUBLE_EQ(multirate.Force(-0.05), -30e3 * 0.04 - 50e3 * 0.01);
  EXPECT_DOUBLE_EQ(multirate.Force(0.05), 30e3 * 0.03 + 20e3 * 0.02);
  EXPECT_DOUBLE_EQ(car.springs.at(1).law.At(values).Force(0.05), 31e3 * 0.05 + 400e3 * 1.25e-4);
  const auto stop = std::find_if(car.springs.begin(), car.springs.end(),
                                 [](const Spring& spring) { return spring.Element() == "fp:stop 'rl'"; });
  ASSERT_NE(stop, car.springs.end());
  EXPECT_DOUBLE_EQ(stop->law.At(values).Force(-0.025), -200e3 * 0.01 - 5e7 * 1e-6);
  EXPECT_DOUBLE_EQ(stop->law.At(values).Force(0.026), 100e3 * 0.01 + 2.5e7 * 1e-6);
  EXPECT_EQ(stop->law.At(values).Force(0.01), 0);
  const auto gas = std::find_if(car.springs.begin(), car.springs.end(),
                                [](const Spring& spring) { return spring.Element() == "the gas of fp:damper 'rl'"; });
  ASSERT_NE(gas, car.springs.end());
  EXPECT_EQ(gas->preload->At(values), -120);
  EXPECT_EQ(gas->law.At(values).Force(0.01), 20);
  const Bushing& left = car.bushings.at(0);
  EXPECT_TRUE(left.holds);
  // 0.2 / (2 pi 12 Hz) of the stiffness.
  EXPECT_DOUBLE_EQ(left.DampingAt(2, values), 400e3 * 0.2 / (2 * std::numbers::pi * 12));
  // rpy = 0.5 0.2 0.1: the x axis by yaw and pitch.
  EXPECT_NEAR(left.axes(0, 0), std::cos(0.1) * std::cos(0.2), 1e-15);
  EXPECT_NEAR(left.axes(2, 0), -std::sin(0.2), 1e-15);
  EXPECT_NEAR(left.axes(2, 1), std::cos(0.2) * std::sin(0.5), 1e-15);
  EXPECT_EQ(car.hinges.at(0).axis, Eigen::Vector3d(0.2, 1, 0.05).normalized());
  EXPECT_EQ(car.sensors.at(7).wheelpan.At(values), 4);
}

}  // namespace
}  // namespace fourpost::element_faults_test
