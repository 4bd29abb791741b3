// One fault at a time in the elements of a car that has them all.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/fault_case.h"
#include "tests/vehicles/small_vehicle.h"

namespace fourpost {
namespace {

class ElementFaults : public VehicleFileTest, public ::testing::WithParamInterface<FaultCase> {
 protected:
  /// Forgets that a parameter is used no more where a fault stands in its place.
  void ForgetUnused() {
    const Diagnostics found = std::exchange(diagnostics_, {});
    for (const Diagnostic& item : found.items())
      if (item.message.find("is not used: bind it") == std::string::npos)
        diagnostics_.Add(item);
  }
};

TEST_P(ElementFaults, AreToldWithTheirLine) {
  const FaultCase& fault = GetParam();
  const std::string text = Replaced(kElementCar, fault.from, fault.to);
  EXPECT_FALSE(Read(text).has_value());
  ForgetUnused();
  Expect(Severity::kError, LineOf(text, fault.at), fault.message);
}

/// A parameter with bounds in place of one without.
FaultCase Bounded(const std::string& name, const std::string& parameter, const std::string& bounds,
                  const std::string& at, const std::string& message) {
  const std::string tag = "<fp:parameter name=\"" + parameter + "\"";
  return {name, tag, "<fp:parameter " + bounds + " name=\"" + parameter + "\"", at, message};
}

const std::string kSlowPoint = R"(<point speed="-$v_table" force="-$f_table"/>)";

INSTANTIATE_TEST_SUITE_P(
    Springs, ElementFaults,
    ::testing::Values(
        FaultCase{"NoKnee", R"(<knee at="$at_bump" stiffness="$k_bump"/>
      <knee at="$at_rebound" stiffness="$k_rebound"/>)",
                  "", "<multirate", "needs at least one <knee>, or make it <linear>"},
        FaultCase{"KneeAtZero", R"(at="$at_bump")", R"(at="0 mm")", R"(at="0 mm")",
                  R"(at="0 mm" of <knee> of <multirate> of fp:spring 'fl' must lie beyond)"},
        FaultCase{"KneesOutOfOrder", R"(<knee at="$at_bump")",
                  R"(<knee at="-50 mm" stiffness="1 N/mm"/><knee at="$at_bump")", "<knee", "beyond the knee before it"},
        Bounded("KneeCrossesZero", "at_rebound", R"(lower="-1 mm" upper="40 mm" precision="1 mm")",
                R"(<knee at="$at_rebound")", "over the whole range of parameters"),
        FaultCase{"KneeWithoutRate", R"(<knee at="$at_bump" stiffness="$k_bump"/>)", R"(<knee at="$at_bump"/>)",
                  R"(<knee at="$at_bump")", "needs the attribute 'stiffness'"},
        FaultCase{"NegativeCubic", R"(name="k3_fr" value="400 kN/m^3")", R"(name="k3_fr" value="-400 kN/m^3")",
                  R"(cubic="$k3_fr")", "must not be negative"},
        FaultCase{"CubicOfOtherDimension", R"(cubic="$k3_fr")", R"(cubic="$k_fr")", R"(cubic="$k_fr")",
                  "refers to a stiffness: a cubic stiffness is needed"},
        FaultCase{"PreloadAndFreeLength", R"(free_length="$l_rr")", R"(free_length="$l_rr" preload="1 kN")",
                  R"(free_length="$l_rr")", "has a preload and a free_length: give one"},
        FaultCase{"EquilibriumAndFreeLength", R"(free_length="$l_rr")", R"(free_length="$l_rr" preload="equilibrium")",
                  R"(free_length="$l_rr")", "has a preload and a free_length: give one"},
        FaultCase{"GuidedFreeLength", R"(<fp:spring name="rr" parent="top_rr" child="seat_rr">)",
                  R"(<fp:spring name="rr" parent="top_rr" child="seat_rr" axis="0 0 1">)", R"(free_length="$l_rr")",
                  "is guided by an axis, so its length is not that of a coil"},
        FaultCase{"ZeroFreeLength", R"(name="l_rr" value="0.33 m")", R"(name="l_rr" value="0 m")",
                  R"(free_length="$l_rr")", "must be above zero"},
        FaultCase{"EmptyStop", R"(axis="0 0 1"><bump gap="$gap_bump" stiffness="$k_stop"/></fp:stop>)",
                  R"(axis="0 0 1"></fp:stop>)", R"(<fp:stop name="rr")", "needs a <bump>, a <rebound> or both"},
        FaultCase{"NegativeGap", R"(name="gap_rebound" value="16 mm")", R"(name="gap_rebound" value="-16 mm")",
                  R"(<rebound)", "gap=\"$gap_rebound\" of <rebound> of fp:stop 'rl' must not be negative"},
        FaultCase{"StopWithoutGap", R"(<rebound gap="$gap_rebound" )", "<rebound ", "<rebound",
                  "needs the attribute 'gap'"}),
    CaseName);

INSTANTIATE_TEST_SUITE_P(
    Dampers, ElementFaults,
    ::testing::Values(
        FaultCase{"NoTransition", R"( speed="$v_smooth")", "", "<smooth", "needs the attribute 'speed'"},
        FaultCase{"ZeroTransition", R"(name="v_smooth" value="0.05 m/s")", R"(name="v_smooth" value="0 m/s")",
                  "<smooth", "must be above zero"},
        FaultCase{"ZeroKneeSpeed", R"(name="v_bump" value="0.06 m/s")", R"(name="v_bump" value="0 m/s")",
                  R"(compression_knee="$v_bump")", "must be above zero"},
        FaultCase{"FlatBeyondTheKnee", R"(rebound_beyond="2*$c_beyond")", R"(rebound_beyond="0 N*s/m")",
                  R"(<series stiffness="$k_mount" cubic)",
                  "fp:damper 'fr' has a series spring: its rates must be above"},
        Bounded("FlatWithinBounds", "c_beyond", R"(lower="0 N*s/m" upper="1 kN*s/m" precision="1 N*s/m")",
                R"(<series stiffness="$k_mount" cubic)", "its rates must be above zero"),
        FaultCase{"SmoothLawThatFalls", R"(compression="$c_bump" rebound="$c_rebound" speed)",
                  R"(compression="0.05*$c_bump" rebound="$c_rebound" speed)", R"(<series stiffness="$k_mount"/>)",
                  "for a smooth law neither rate may be more than eleven times the other"},
        Bounded("SmoothLawThatFallsWithinBounds", "c_rebound",
                R"(lower="2 kN*s/m" upper="14 kN*s/m" precision="1 N*s/m")", R"(<series stiffness="$k_mount"/>)",
                "for a smooth law neither rate may be more than eleven times the other"),
        FaultCase{"NoPoints",
                  R"(<point speed="-4*$v_table" force="-2*$f_table"/><point speed="-$v_table" force="-$f_table"/>
      <point speed="$v_table" force="2*$f_table"/><point speed="5*$v_table" force="4*$f_table"/>)",
                  R"(<point speed="$v_table" force="$f_table"/>)", "<table>", "needs at least two <point>s"},
        FaultCase{"PointThatPushes", kSlowPoint, "\n<point speed=\"-$v_table\" force=\"0.1*$f_table\"/>",
                  R"(<point speed="-$v_table")", "pushes on its own motion"},
        FaultCase{"PointThatPushesAtRest", kSlowPoint, "\n<point speed=\"0 m/s\" force=\"20 N\"/>",
                  R"(<point speed="0 m/s")", "pushes on its own motion"},
        FaultCase{"PointsOutOfOrder", kSlowPoint, "\n<point speed=\"-5*$v_table\" force=\"-$f_table\"/>",
                  R"(<point speed="-5*)", "must have more speed and more force than the point before it"},
        FaultCase{"PointsOfOneForce", kSlowPoint, "\n<point speed=\"-$v_table\" force=\"-2*$f_table\"/>",
                  R"(<point speed="-$v)", "must have more speed and more force than the point before it"},
        FaultCase{"FrictionWithoutSpeed", R"(name="v_friction" value="3 mm/s")", R"(name="v_friction" value="0 mm/s")",
                  R"(<friction force="$f_friction" speed)", "must be above zero"},
        FaultCase{"NegativeGas", R"(name="f_gas" value="120 N")", R"(name="f_gas" value="-120 N")", "<gas",
                  "must not be negative"},
        FaultCase{"ThickRod", R"(name="rod" value="12 mm")", R"(name="rod" value="30 mm")", R"(rod="$rod")",
                  R"(rod="$rod" of <hydraulic> of fp:damper 'rr' must be thinner than the piston, "$bore")"},
        Bounded("ThickRodWithinBounds", "rod", R"(lower="10 mm" upper="31 mm" precision="1 mm")", R"(rod="$rod")",
                "must be thinner than the piston"),
        FaultCase{
            "GasThatCavitates", R"(name="p_gas" value="2 MPa")", R"(name="p_gas" value="5 kPa")",
            R"(gas_pressure="$p_gas")",
            R"(gas_pressure="$p_gas" of <hydraulic> of fp:damper 'rr' must be above that of cavitation, "5 kPa")"},
        FaultCase{"HighCavitation", R"(<hydraulic bleed="$bleed" rebound_valve="2*$valve"/>)",
                  R"(<hydraulic bleed="$bleed" rebound_valve="2*$valve" cavitation="20 bar"/>)", "cavitation=\"20 bar",
                  "must be above that of cavitation, \"20 bar\""},
        FaultCase{"NoDensity", R"(<hydraulic bleed="$bleed" rebound_valve="2*$valve"/>)",
                  R"(<hydraulic bleed="$bleed" rebound_valve="2*$valve" density="0 kg/m^3"/>)", "density=\"0 kg",
                  "must be above zero"},
        Bounded("GasThatCavitatesWithinBounds", "p_gas", R"(lower="1 kPa" upper="3 MPa" precision="1 kPa")",
                R"(gas_pressure="$p_gas")", "must be above that of cavitation"),
        FaultCase{"NoBleed", R"(<hydraulic bleed="$bleed" rebound_valve="2*$valve"/>)",
                  R"(<hydraulic bleed="0 mm^2" rebound_valve="2*$valve"/>)", "<hydraulic bleed=\"0",
                  "must be above zero"},
        FaultCase{"FaultyParameterOfALaw", R"(name="v_smooth" value="0.05 m/s")", R"(name="v_smooth" value="fast")",
                  R"(name="v_smooth")", "is not a number with a unit"}),
    CaseName);

INSTANTIATE_TEST_SUITE_P(
    Bushings, ElementFaults,
    ::testing::Values(
        FaultCase{"NothingInIt", R"(<translation x="0.1*$k_x" y="0.1*$k_y"/>
    <rotation x="$kr"/>)",
                  "", R"(<fp:bushing name="hanger")", "fp:bushing 'hanger' resists nothing: give it a <translation>"},
        FaultCase{"OtherPreload", R"(child="foot_left" preload="equilibrium")", R"(child="foot_left" preload="100 N")",
                  R"(child="foot_left")", "preload"},
        FaultCase{"StiffnessOfOtherDimension", R"(<translation x="0.1*$k_x" y="0.1*$k_y"/>)",
                  R"(<translation x="0.1*$kr" y="0.1*$k_y"/>)", R"(x="0.1*$kr")", "a stiffness is needed"},
        FaultCase{"RotationOfOtherDimension", R"(<rotation x="$kr"/>)", R"(<rotation x="$k_x"/>)",
                  R"(<rotation x="$k_x")", "a torque is needed"},
        FaultCase{"ParameterOfAFrequency", R"(<loss factor="$loss" frequency="12 Hz"/>)",
                  R"(<loss factor="$loss" frequency="$f_loss"/></fp:bushing>
  <fp:parameter name="f_loss" value="12 Hz" source="test"/><fp:bushing name="none" parent="mount_left" child="foot_left">
    <rotation x="1 N*m/rad"/>)",
                  "<loss", R"(frequency="$f_loss" of <loss> of fp:bushing 'left' must be a number)"},
        FaultCase{"ZeroFrequency", R"(frequency="12 Hz")", R"(frequency="0 Hz")", "<loss", "must be above zero"},
        FaultCase{"NegativeLoss", R"(name="loss" value="0.2")", R"(name="loss" value="-0.2")", "<loss",
                  "must not be negative"},
        FaultCase{"TurnOfTwoNumbers", R"(rpy="0 0.7 0")", R"(rpy="0 0.7")", R"(rpy="0 0.7")", "must be three numbers"},
        FaultCase{"BushingWithBothEndsOnALink", R"(parent="hanger" child="tail")", R"(parent="hanger" child="hook")",
                  R"(<fp:bushing name="hanger")", "has both ends on link 'chassis': it joins nothing"},
        FaultCase{"NoRightLine", R"(<right parent="bar_right" child="drop_right" axis="0 0 1"/>)", "", "<fp:antiroll",
                  "<right>"},
        FaultCase{"LineOnOneLink", R"(<left parent="bar_left" child="drop_left"/>)",
                  R"(<left parent="bar_left" child="bar_right"/>)", "<left", "its length can never change"},
        FaultCase{"LineWithoutLength", R"(<fp:frame name="bar_left" link="chassis" xyz="1.1 0.45 0"/>)",
                  R"(<fp:frame name="bar_left" link="chassis" xyz="1.1 0.48 -0.2"/>)", "<fp:antiroll",
                  "the left line of fp:antiroll 'front' has no length"},
        FaultCase{"BarWithoutStiffness", R"(name="front" stiffness="$k_bar")", R"(name="front" )", "<fp:antiroll",
                  "needs the attribute 'stiffness'"}),
    CaseName);

INSTANTIATE_TEST_SUITE_P(
    Tyres, ElementFaults,
    ::testing::Values(
        FaultCase{"NegativeRadius", R"(stiffness="$kt" radius="0.35 m")", R"(stiffness="$kt" radius="-0.35 m")",
                  R"(<fp:tyre name="fr")", "must not be negative"},
        FaultCase{"ParameterOfARadius", R"(stiffness="$kt" radius="0.35 m")", R"(stiffness="$kt" radius="$l_rr")",
                  R"(<fp:tyre name="fr")",
                  R"(radius="$l_rr" of fp:tyre 'fr' must be a number: no parameter can change it)"},
        FaultCase{"NeitherLiftsNorNot", R"(stiffness="$kt" radius="0.35 m")",
                  R"(stiffness="$kt" liftoff="yes" radius="0.35 m")", R"(<fp:tyre name="fr")", "liftoff"},
        FaultCase{"LateralOfOtherDimension", R"(stiffness="$kt" radius="0.35 m" lateral="$k_side")",
                  R"(stiffness="$kt" radius="0.35 m" lateral="$ct")", R"(<fp:tyre name="fr")", "a stiffness is needed"},
        FaultCase{"WheelOnItsSide", R"(<origin xyz="-1.3 0.7 0.35"/>)",
                  R"(<origin xyz="-1.3 0.7 0.35" rpy="1.6 0 0"/>)", R"(<fp:tyre name="rl")",
                  "wheel turns about the y axis of link 'hub', but that does not point sideways"},
        FaultCase{"WheelThatRollsSideways", R"(<origin xyz="-1.3 0.7 0.35"/>)",
                  R"(<origin xyz="-1.3 0.7 0.35" rpy="0 0 1.6"/>)", R"(<fp:tyre name="rl")", "does not point sideways"},
        FaultCase{"WheelpanOfOtherDimension", R"(wheelpan="0.5*$m_pan")", R"(wheelpan="0.5*$kt")", R"(name="F_rl")",
                  "a mass is needed"},
        FaultCase{"NegativeWheelpan", R"(wheelpan="0.5*$m_pan")", R"(wheelpan="-1 kg")", R"(name="F_rl")",
                  "must not be negative"},
        FaultCase{"GyroWithoutAxis", R"( link="engine" axis="0.3 1 0.1")", R"( link="engine")", R"(name="pitch")",
                  "needs the attribute 'axis'"},
        FaultCase{"GyroAtAPoint", R"( link="engine" axis="0.3 1 0.1")", R"( link="engine" axis="0 1 0" xyz="0 0 0")",
                  R"(name="pitch")", "unknown attribute 'xyz'"},
        FaultCase{"GyroOfNoLink", R"( link="engine" axis="0.3 1 0.1")", R"( link="motor" axis="0 1 0")",
                  R"(name="pitch")", "unknown link 'motor'"}),
    CaseName);

INSTANTIATE_TEST_SUITE_P(
    Loops, ElementFaults,
    ::testing::Values(
        FaultCase{"HingeWithoutAxis", R"( axis="0.2 1 0.05")", "", "<fp:hinge", "needs the attribute 'axis'"},
        FaultCase{"HingeOfZeroAxis", R"( axis="0.2 1 0.05")", R"( axis="0 0 0")", "<fp:hinge", "must not be zero"},
        FaultCase{"HingeWithBothEndsOnALink", R"(parent="pivot" child="hinged" axis)",
                  R"(parent="pivot" child="chassis" axis)", "<fp:hinge", "has both ends on link 'chassis'"},
        FaultCase{"WeldWithBothEndsOnALink", R"(parent="arm_end" child="hub")", R"(parent="arm_end" child="arm")",
                  "<fp:weld", "fp:weld 'wheel' has both ends on link 'arm': it joins nothing"},
        FaultCase{"WeldToNothing", R"(parent="arm_end" child="hub")", R"(parent="arm_end" child="hubb")", "<fp:weld",
                  "unknown frame or link 'hubb', did you mean 'hub'?"},
        FaultCase{"WeldTwice", R"(<fp:weld name="wheel" parent="arm_end" child="hub"/>)",
                  "<fp:weld name=\"wheel\" parent=\"arm_end\" child=\"hub\"/>\n<fp:weld  name=\"wheel\" "
                  "parent=\"arm_end\" child=\"hub\"/>",
                  "<fp:weld  name", "is already defined"}),
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
  Expect(Severity::kError, LineOf(text, R"(<point speed="-$v_table")"), "over the whole range of parameters");
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
}  // namespace fourpost
