#include "vehicles/lint/vehicle_lint.h"

#include <algorithm>
#include <utility>

#include <gmock/gmock.h>

#include "tests/vehicles/lint_all.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/description/drawn_vehicle.h"

namespace fourpost {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// An axle's share of a car, without a fault and without anything odd: a body that heaves and rolls on two wheels.
const std::string kAxle = R"(<robot name="axle" xmlns:fp="urn:fourpost:vehicle:1">
<link name="ground"/>
<link name="heave"/>
<link name="body">
  <inertial>
    <origin xyz="0 0 0"/><mass value="500"/>
    <inertia ixx="100" iyy="100" izz="100" ixy="0" ixz="0" iyz="0"/>
  </inertial>
</link>
<link name="wheel_left">
  <inertial><mass value="40"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
</link>
<link name="wheel_right">
  <inertial><mass value="40"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
</link>
<joint name="heave" type="prismatic">
  <parent link="ground"/><child link="heave"/><origin xyz="0 0 0.8"/><axis xyz="0 0 1"/>
  <limit effort="0" velocity="0"/>
</joint>
<joint name="roll" type="continuous"><parent link="heave"/><child link="body"/><axis xyz="1 0 0"/></joint>
<joint name="travel_left" type="prismatic">
  <parent link="ground"/><child link="wheel_left"/><origin xyz="0 0.7 0.3"/><axis xyz="0 0 1"/>
  <limit effort="0" velocity="0"/>
</joint>
<joint name="travel_right" type="prismatic">
  <parent link="ground"/><child link="wheel_right"/><origin xyz="0 -0.7 0.3"/><axis xyz="0 0 1"/>
  <limit effort="0" velocity="0"/>
</joint>
<fp:frame name="top_left" link="body" xyz="0 0.7 0"/>
<fp:frame name="top_right" link="body" xyz="0 -0.7 0"/>
<fp:spring name="coil_left" parent="top_left" child="wheel_left"><linear stiffness="30 kN/m"/></fp:spring>
<fp:spring name="coil_right" parent="top_right" child="wheel_right"><linear stiffness="30 kN/m"/></fp:spring>
<fp:damper name="damper_left" parent="top_left" child="wheel_left">
  <bilinear compression="1000 N*s/m" rebound="2000 N*s/m"/>
</fp:damper>
<fp:damper name="damper_right" parent="body" child="wheel_right">
  <bilinear compression="999 N*s/m" rebound="2000 N*s/m"/>
</fp:damper>
<fp:antiroll name="bar" stiffness="5 kN/m">
  <left parent="body" child="wheel_left"/><right parent="body" child="wheel_right"/>
</fp:antiroll>
<fp:tyre name="tyre_left" link="wheel_left" xyz="0 0 0" radius="0.3 m" stiffness="200 kN/m"/>
<fp:tyre name="tyre_right" link="wheel_right" xyz="0 0 0" radius="0.3 m" stiffness="200 kN/m"/>
<fp:post name="left" under="tyre_left"/>
<fp:post name="right" under="tyre_right"/>
<fp:sensor name="a_body" type="accelerometer" link="body" xyz="0 0 0.2"/>
</robot>
)";

/// A rigid body on its tyres.
std::string Kart(const std::string& tyre) {
  std::string text = R"(<robot name="kart" xmlns:fp="urn:fourpost:vehicle:1">
<link name="ground"/>
<link name="body">
  <inertial><mass value="200"/><inertia ixx="30" iyy="60" izz="80" ixy="0" ixz="0" iyz="0"/></inertial>
</link>
<joint name="body" type="floating"><parent link="ground"/><child link="body"/><origin xyz="0 0 0.2"/></joint>
<fp:sensor name="a_body" type="accelerometer" link="body" xyz="0 0 0"/>
)";
  for (const auto& [name, xyz] : {std::pair("FL", "0.5 0.5 0"), std::pair("FR", "0.5 -0.5 0"),
                                  std::pair("RL", "-0.5 0.5 0"), std::pair("RR", "-0.5 -0.5 0")})
    text += std::string("<fp:tyre name=\"") + name + "\" link=\"body\" xyz=\"" + xyz + "\" stiffness=\"100 kN/m\" " +
            tyre + "/><fp:post name=\"" + name + "\" under=\"" + name + "\"/>\n";
  return text + "</robot>\n";
}

/// Looks at descriptions of one side each of whose texts a test changes.
class VehicleLintTest : public VehicleFileTest {
 protected:
  /// Takes the findings about a description for those that the test has to expect.
  void Look(const std::string& text) {
    const std::optional<Vehicle> vehicle = Read(text);
    ASSERT_TRUE(vehicle.has_value()) << diagnostics_.Format();
    EXPECT_EQ(diagnostics_.Format(), "");
    diagnostics_ = Lint(*vehicle);
  }

  /// Takes one finding in the line of `at`.
  void ExpectWarning(const std::string& text, const std::string& at, const std::string& message) {
    Expect(Severity::kWarning, LineOf(text, at), message);
  }
};

/// Messages of the findings, all of them warnings, each in the line expected.
std::vector<std::string> Findings(const Vehicle& vehicle, int line) {
  std::vector<std::string> messages;
  const Diagnostics findings = Lint(vehicle);
  for (const Diagnostic& item : findings.items()) {
    EXPECT_EQ(item.severity, Severity::kWarning);
    EXPECT_EQ(item.file, vehicle.file);
    EXPECT_EQ(item.line, line) << item.message;
    messages.push_back(item.message);
  }
  return messages;
}

std::vector<std::string> OddInDescription(const Vehicle& vehicle) {
  std::vector<std::string> messages;
  const Diagnostics findings = LintDescription(vehicle);
  for (const Diagnostic& item : findings.items()) messages.push_back(item.message);
  return messages;
}

Vehicle QuarterCar() { return ShippedVehicle("quarter_car"); }

/// With a tyre that damps whatever else does not.
Vehicle DampedQuarterCar() {
  Vehicle vehicle = QuarterCar();
  vehicle.tyres[0].damping = {.value = 500};
  return vehicle;
}

TEST(VehicleLint, FindsNothingInTheShippedVehicles) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf"))
    if (entry.path().extension() == ".urdf") {
      EXPECT_EQ(Lint(ShippedVehicle(entry.path().stem())).Format(), "");
      ++count;
    }
  EXPECT_GE(count, 5);
}

TEST_F(VehicleLintTest, FindsNothingInASoundDescription) { Look(kAxle); }

TEST_F(VehicleLintTest, TellsOfPointsThatAreNearlyMirrored) {
  const std::string text = Replaced(kAxle, R"(<fp:frame name="top_right" link="body" xyz="0 -0.7 0"/>)",
                                    R"(<fp:frame name="top_right" link="body" xyz="0.012 -0.7 0"/>)");
  Look(text);
  ExpectWarning(text, R"(<fp:spring name="coil_right")",
                "parent's end of fp:spring 'coil_right' is 12 mm off the mirror image of that of fp:spring 'coil_left' "
                "(line " +
                    std::to_string(LineOf(text, "<fp:spring name=\"coil_left\"")) + ")");
}

TEST_F(VehicleLintTest, LetsSidesDifferThatAreNotMeantToBeMirrored) {
  Look(Replaced(kAxle, R"(<fp:frame name="top_right" link="body" xyz="0 -0.7 0"/>)",
                R"(<fp:frame name="top_right" link="body" xyz="0.2 -0.7 0"/>)"));
  EXPECT_EQ(diagnostics_.Format(), "");
  // Printed to a tenth of a millimetre.
  Look(Replaced(kAxle, R"(<fp:frame name="top_right" link="body" xyz="0 -0.7 0"/>)",
                R"(<fp:frame name="top_right" link="body" xyz="0 -0.70005 0"/>)"));
}

TEST_F(VehicleLintTest, TellsOfNumbersThatDifferByATypingSlip) {
  const std::string text = Replaced(kAxle, "999 N*s/m", "99.9 N*s/m");
  Look(text);
  ExpectWarning(text, R"(<fp:damper name="damper_right")",
                "compression rate of fp:damper 'damper_right' is 99.9 N*s/m, that of fp:damper 'damper_left'");
}

TEST_F(VehicleLintTest, TellsOfACoilAtHalfTheOthersRate) {
  const std::string at = R"(<fp:spring name="coil_right" parent="top_right" child="wheel_right">)";
  const std::string text =
      Replaced(kAxle, at + R"(<linear stiffness="30 kN/m"/>)", at + R"(<linear stiffness="15 kN/m"/>)");
  Look(text);
  ExpectWarning(text, at, "stiffness of fp:spring 'coil_right' is 15 kN/m, that of fp:spring 'coil_left'");
}

TEST_F(VehicleLintTest, LetsTypedNumbersOfBothSidesDifferByRounding) {
  Look(Replaced(kAxle, "999 N*s/m", "991 N*s/m"));
  const std::string text = Replaced(kAxle, "999 N*s/m", "989 N*s/m");
  Look(text);
  ExpectWarning(text, R"(<fp:damper name="damper_right")", "make them parameters if they were measured so");
}

TEST_F(VehicleLintTest, LetsParametersOfBothSidesDifferByHalf) {
  const auto text = [](const std::string& value) {
    return Replaced(Replaced(kAxle, "999 N*s/m", "$c"), "</robot>",
                    "<fp:parameter name=\"c\" value=\"" + value + "\" source=\"fit\"/></robot>");
  };
  Look(text("670 N*s/m"));
  Look(text("660 N*s/m"));
  ExpectWarning(text("660 N*s/m"), R"(<fp:damper name="damper_right")", "compression rate of fp:damper 'damper_right'");
}

TEST(VehicleLint, TellsOfATyreInNewtonsPerMetre) {
  Vehicle vehicle = DampedQuarterCar();
  Set(vehicle, "kt", 230);
  EXPECT_THAT(Findings(vehicle, vehicle.tyres[0].source_line),
              ElementsAre("stiffness of fp:tyre 'tyre' is 0.23 kN/m, not within 20 kN/m to 2 MN/m; was 230 kN/m "
                          "meant?"));
}

TEST(VehicleLint, TellsOfASpringInNewtonsPerMetre) {
  Vehicle vehicle = QuarterCar();
  Set(vehicle, "k", 15);
  EXPECT_THAT(Findings(vehicle, vehicle.springs[0].source_line),
              ElementsAre(HasSubstr("stiffness of fp:spring 'spring' is 0.015 kN/m, not within 1 kN/m to 1 MN/m; was "
                                    "15 kN/m meant?")));
}

TEST(VehicleLint, TellsOfADamperInKilonewtons) {
  Vehicle vehicle = DampedQuarterCar();
  Set(vehicle, "c_bump", 1.5e6);
  Set(vehicle, "c_rebound", 1.5e6);
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre(HasSubstr("compression rate of fp:damper 'damper' is"), HasSubstr("was 1.5 kN*s/m meant?")));
}

TEST(VehicleLint, TellsOfATyreDampedInKilonewtons) {
  Vehicle vehicle = QuarterCar();
  vehicle.tyres[0].damping = {.value = 150e3};
  EXPECT_THAT(Findings(vehicle, vehicle.tyres[0].source_line),
              ElementsAre("damping of fp:tyre 'tyre' is 150 kN*s/m, above 20 kN*s/m; was 150 N*s/m meant?"));
}

TEST(VehicleLint, TellsOfMasses) {
  Vehicle light = QuarterCar();
  Set(light, "m_unsprung", 22e-5);
  EXPECT_THAT(Findings(light, light.links[1].line), ElementsAre(HasSubstr("was 220 g meant?")));
  Vehicle heavy = QuarterCar();
  Set(heavy, "m_sprung", 2e5);
  EXPECT_THAT(Findings(heavy, heavy.links[2].line),
              ElementsAre(HasSubstr("mass of link 'sprung' is 200000 kg, not within 1 g to 100 t; was 200 kg meant?")));
}

TEST(VehicleLint, TellsOfABushingAsStiffAsARock) {
  Vehicle vehicle = QuarterCar();
  vehicle.bushings.push_back({.name = "mount", .parent = {2, {0, 0, 0}}, .child = {1, {0, 0, 0.4}}, .source_line = 7});
  vehicle.bushings[0].stiffness[1].value = 0.9e9;
  EXPECT_THAT(Findings(vehicle, 7), IsEmpty());
  vehicle.bushings[0].stiffness[1].value = 3e9;
  EXPECT_THAT(Findings(vehicle, 7), ElementsAre(HasSubstr("stiffness along y of fp:bushing 'mount' is 3000 MN/m")));
}

TEST(VehicleLint, TellsOfATyresRadius) {
  Vehicle vehicle = QuarterCar();
  vehicle.tyres[0].radius = 2.5;
  vehicle.tyres[0].point.xyz.z() = 2.2;
  EXPECT_THAT(Findings(vehicle, vehicle.tyres[0].source_line),
              ElementsAre(HasSubstr("radius of fp:tyre 'tyre' is 2.5 m, not within 100 mm to 2 m; check its digits")));
}

TEST(VehicleLint, TellsOfMillimetres) {
  Vehicle vehicle = QuarterCar();
  vehicle.dampers[0].line.parent.xyz.y() = 350;
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre("parent's end of fp:damper 'damper' is 350 m from the origin of its axes; was 350 mm meant? "
                          "xyz is in metres"));
}

TEST(VehicleLint, TellsOfAJointsOriginInMillimetres) {
  Vehicle vehicle = QuarterCar();
  vehicle.joints[1].pose.translation().y() = 700;
  EXPECT_THAT(Findings(vehicle, vehicle.joints[1].line),
              ElementsAre(HasSubstr("the origin of joint 'body_travel' is 700 m from the origin of its axes")));
}

Spring Stop(double bump_m, double rebound_m) {
  Spring stop = QuarterCar().springs[0];
  stop.kind = Spring::Kind::kStop;
  stop.name = "stop";
  stop.preload = Scalar();
  stop.law = {.stiffness = {},
              .cubic = {},
              .knees = {{.side = -1, .at = {.value = bump_m}, .rate = {.value = 1e5}, .cubic = {}, .adds = true},
                        {.side = 1, .at = {.value = rebound_m}, .rate = {.value = 1e5}, .cubic = {}, .adds = true}}};
  return stop;
}

TEST(VehicleLint, TellsOfAStopWithoutGaps) {
  Vehicle vehicle = QuarterCar();
  vehicle.springs.push_back(Stop(0, 0));
  EXPECT_THAT(Findings(vehicle, vehicle.springs[1].source_line),
              ElementsAre(HasSubstr("fp:stop 'stop' has no gap on either side")));
  vehicle.springs[1] = Stop(0, 0.1);
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
}

TEST(VehicleLint, TellsOfSwappedDamping) {
  Vehicle vehicle = QuarterCar();
  Set(vehicle, "c_rebound", 200);
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre("fp:damper 'damper' resists compression with 1.5 kN*s/m and rebound with 200 N*s/m: are the "
                          "two swapped?"));
  Set(vehicle, "c_rebound", 400);
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
}

// The body's mesh and its coil's end reach up to 0.2 m.
TEST(VehicleLint, TellsOfASensorOffItsBody) {
  Vehicle vehicle = QuarterCar();
  vehicle.sensors[0].point.xyz = {0, 0, 0.75};
  EXPECT_THAT(Findings(vehicle, vehicle.sensors[0].source_line),
              ElementsAre("fp:sensor 'a_sprung' is 550 mm off all that the file tells of link 'sprung', which carries "
                          "it: correct the link, or xyz, which is in metres and in the axes of its link"));
  vehicle.sensors[0].point.xyz = {0, 0, 0.65};
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
}

TEST(VehicleLint, TellsOfASensorOfOneAxleBesideTheOther) {
  Vehicle vehicle = ShippedVehicle("landrover110");
  const auto sensor = std::find_if(vehicle.sensors.begin(), vehicle.sensors.end(),
                                   [](const Sensor& one) { return one.name == "a_axle_FL"; });
  ASSERT_NE(sensor, vehicle.sensors.end());
  sensor->point.xyz.x() -= 2.794;
  EXPECT_THAT(Findings(vehicle, sensor->source_line), ElementsAre(HasSubstr("off all that the file tells of link")));
}

TEST(VehicleLint, TellsOfASensorThatReadsNothing) {
  Vehicle vehicle = QuarterCar();
  vehicle.sensors[0].point.link = 0;
  EXPECT_THAT(Findings(vehicle, vehicle.sensors[0].source_line),
              ElementsAre(HasSubstr("fp:sensor 'a_sprung' reads nothing, however the vehicle moves")));
  vehicle.sensors[0].point.link = 2;
  vehicle.sensors[0].axis = Eigen::Vector3d::UnitY();
  EXPECT_THAT(Findings(vehicle, vehicle.sensors[0].source_line), ElementsAre(HasSubstr("reads nothing")));
}

TEST(VehicleLint, TellsOfAnInertiaThatNoBodyOfThisSizeHas) {
  Vehicle vehicle = QuarterCar();
  for (const std::size_t i : {1, 2}) vehicle.links[1].inertia[i].value = 22;  // 1 m about
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
  for (const std::size_t i : {1, 2}) vehicle.links[1].inertia[i].value = 550;
  EXPECT_THAT(Findings(vehicle, vehicle.links[1].line),
              ElementsAre(HasSubstr("inertia of link 'unsprung' is 550 kg*m^2 at a mass of 22 kg, a radius of gyration "
                                    "of 5 m, beyond all")));
}

/// A number of a quarter car that no vehicle has.
struct OddNumber {
  std::string name;
  void (*change)(Vehicle& vehicle);
  std::string message;
};

std::ostream& operator<<(std::ostream& out, const OddNumber& odd) { return out << odd.name; }

Scalar Fixed(double value) { return {.value = value}; }

DashpotDescription MeasuredCurve(double speed_mps) {
  return {.kind = DashpotDescription::Kind::kTable,
          .compression = {},
          .rebound = {},
          .table = {{Fixed(-speed_mps), Fixed(-900)}, {Fixed(speed_mps), Fixed(1500)}}};
}

HydraulicDescription Oil() {
  return {.bleed = Fixed(6e-7),
          .rebound_valve = Fixed(1e7),
          .compression_valve = Fixed(2.597e6),
          .bulk_modulus = Fixed(3e8),
          .piston_diameter = Fixed(0.03),
          .rod_diameter = Fixed(0.0125),
          .rebound_column = Fixed(0.1),
          .compression_column = Fixed(0.1),
          .gas_pressure = Fixed(2e6),
          .gas_volume = Fixed(60e-6),
          .gas_exponent = Fixed(1.3),
          .density = Fixed(860),
          .cavitation = Fixed(5e3)};
}

const std::vector<OddNumber> kOddNumbers = {
    {"friction",
     [](Vehicle& car) {
       car.dampers[0].law.friction = {Fixed(25e3), Fixed(0.002)};
     },
     "friction of fp:damper 'damper' is 25 kN, not within 0.1 N to 5 kN; was 25 N meant?"},
    {"friction_speed",
     [](Vehicle& car) {
       car.dampers[0].law.friction = {Fixed(25), Fixed(2)};
     },
     "friction speed of fp:damper 'damper' is 2 m/s, not within 0.0001 m/s to 0.1 m/s; was 0.002 m/s meant?"},
    {"series", [](Vehicle& car) { car.dampers[0].series = SpringDescription{.stiffness = Fixed(0.4)}; },
     "series stiffness of fp:damper 'damper' is 0.4 N/m"},
    {"stop", [](Vehicle& car) { car.springs[1].law.knees[0].rate = Fixed(80); },
     "bump stiffness of fp:stop 'stop' is 80 N/m, not within 1 kN/m to 100 MN/m; was 80 kN/m meant?"},
    {"gap", [](Vehicle& car) { car.springs[1].law.knees[0].at = Fixed(30); },
     "bump gap of fp:stop 'stop' is 30 m, not within 0.1 mm to 500 mm; was 30 mm meant?"},
    {"knee",
     [](Vehicle& car) {
       car.springs[0].law.knees = {{-1, Fixed(2), Fixed(3e4), {}, false}};
     },
     "place of bump knee 1 of fp:spring 'spring' is 2 m"},
    {"knee_rate",
     [](Vehicle& car) {
       car.springs[0].law.knees = {{-1, Fixed(0.02), Fixed(30), {}, false}};
     },
     "stiffness beyond bump knee 1 of fp:spring 'spring' is 30 N/m"},
    {"knee_speed",
     [](Vehicle& car) {
       car.dampers[0].law.kind = DashpotDescription::Kind::kDigressive;
       car.dampers[0].law.compression_knee = {Fixed(150), Fixed(500)};
       car.dampers[0].law.rebound_knee = {Fixed(0.15), Fixed(500)};
     },
     "compression knee of fp:damper 'damper' is 150 m/s, not within 0.001 m/s to 5 m/s; was 0.15 m/s meant?"},
    {"lateral", [](Vehicle& car) { car.tyres[0].lateral = Fixed(90); },
     "lateral stiffness of fp:tyre 'tyre' is 90 N/m"},
    {"tyre_damping", [](Vehicle& car) { car.tyres[0].damping = Fixed(100e3); },
     "damping of fp:tyre 'tyre' is 100 kN*s/m, above 20 kN*s/m; was 100 N*s/m meant?"},
    {"wheelpan",
     [](Vehicle& car) {
       car.sensors.push_back({.name = "F", .type = Sensor::Type::kLoadCell, .tyre = 0, .wheelpan = Fixed(25e3)});
     },
     "wheelpan of fp:sensor 'F' is 25 t, not within 10 g to 1 t; was 25 kg meant?"},
    {"table", [](Vehicle& car) { car.dampers[0].law = MeasuredCurve(500); },
     "speed in the table of fp:damper 'damper' is -500 m/s, above 10 m/s; was -0.5 m/s meant?"},
    {"mean_rate", [](Vehicle& car) { car.dampers[0].law = MeasuredCurve(0.001); },
     "mean rate of fp:damper 'damper' up to 0.1 m/s is 1.2 MN*s/m, not within 10 N*s/m to 100 kN*s/m; was 1.2 kN*s/m"},
    {"bleed",
     [](Vehicle& car) {
       car.dampers[0].hydraulic = Oil();
       car.dampers[0].hydraulic->bleed = Fixed(3);
     },
     "bleed of fp:damper 'damper' is 3 m^2"},
    {"piston",
     [](Vehicle& car) {
       car.dampers[0].hydraulic = Oil();
       car.dampers[0].hydraulic->piston_diameter = Fixed(0.3);
     },
     "piston of fp:damper 'damper' is 300 mm, not within 10 mm to 150 mm"},
    {"valve",
     [](Vehicle& car) {
       car.dampers[0].hydraulic = Oil();
       car.dampers[0].hydraulic->compression_valve = Fixed(10);
     },
     "compression_valve of fp:damper 'damper' is 10 "},
    {"gas_volume",
     [](Vehicle& car) {
       car.dampers[0].hydraulic = Oil();
       car.dampers[0].hydraulic->gas_volume = Fixed(60);
     },
     "gas_volume of fp:damper 'damper' is 60 m^3"},
    {"antiroll",
     [](Vehicle& car) {
       ForceLine to_ground = car.springs[0].line;
       to_ground.child.link = 0;
       car.antiroll_bars.push_back(
           {.name = "bar", .left = car.springs[0].line, .right = to_ground, .stiffness = Fixed(0.06)});
     },
     "stiffness of fp:antiroll 'bar' is 0.06 N/m, not within 100 N/m to 10 MN/m"},
};

class OddNumbers : public testing::TestWithParam<OddNumber> {};

TEST_P(OddNumbers, AreTold) {
  Vehicle vehicle = QuarterCar();
  vehicle.springs.push_back(Stop(0.03, 0.05));
  EXPECT_EQ(LintDescription(vehicle).Format(), "");
  GetParam().change(vehicle);
  EXPECT_THAT(OddInDescription(vehicle), testing::Contains(HasSubstr(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(All, OddNumbers, testing::ValuesIn(kOddNumbers),
                         [](const auto& test) { return test.param.name; });

TEST(VehicleLint, TakesOilAndMeasuredCurvesForUsual) {
  Vehicle vehicle = QuarterCar();
  vehicle.dampers[0].law = MeasuredCurve(0.5);
  EXPECT_EQ(LintDescription(vehicle).Format(), "");
  vehicle.dampers[0].hydraulic = Oil();
  EXPECT_EQ(LintDescription(vehicle).Format(), "");
}

TEST(VehicleLint, TellsOfAStopThatNothingCanReach) {
  Vehicle vehicle = ShippedVehicle("single_wheel_station");
  Spring stop = Stop(0.1, 0.1);
  stop.line = vehicle.springs[0].line;
  stop.line.axis.reset();
  stop.line.parent.xyz.setZero();
  stop.line.child.xyz.setZero();
  vehicle.springs.push_back(stop);
  const double length = DrawnVehicle(vehicle).Length(stop.line);
  vehicle.springs.back().law.knees[0].at = Fixed(1.1 * length);
  EXPECT_THAT(OddInDescription(vehicle), testing::Contains(HasSubstr("so it is never compressed by")));
}

TEST(VehicleLint, TellsOfAPistonThatMeetsItsEndBeforeTheStop) {
  Vehicle vehicle = QuarterCar();
  vehicle.springs.push_back(Stop(0.03, 0.05));
  vehicle.dampers[0].hydraulic = Oil();
  vehicle.dampers[0].hydraulic->rebound_column = Fixed(0.04);
  vehicle.parameters.resize(4);  // all but the damper's
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre(HasSubstr("the rebound column of fp:damper 'damper' is 40 mm long, but fp:stop 'stop' begins "
                                    "after 50 mm")));
}

TEST(VehicleLint, TellsOfSwappedDampingInATable) {
  Vehicle vehicle = QuarterCar();
  vehicle.dampers[0].law = MeasuredCurve(0.1);
  vehicle.dampers[0].law.table[0].force = Fixed(-8 * 1500);
  vehicle.parameters.resize(4);  // all but the damper's
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre("fp:damper 'damper' resists compression with 120 kN*s/m and rebound with 15 kN*s/m at 0.1 "
                          "m/s: are the two swapped?"));
}

TEST(VehicleLint, TellsOfSwappedDampingInAHydraulicDamper) {
  Vehicle vehicle = QuarterCar();
  vehicle.dampers[0].hydraulic = Oil();
  std::swap(vehicle.dampers[0].hydraulic->rebound_valve, vehicle.dampers[0].hydraulic->compression_valve);
  vehicle.dampers[0].hydraulic->bleed = Fixed(1e-5);
  vehicle.dampers[0].hydraulic->compression_valve = Fixed(5e7);
  vehicle.dampers[0].hydraulic->rebound_valve = Fixed(1e6);
  EXPECT_EQ(LintDescription(vehicle).Format(), "");  // with this bleed the valves hardly matter
  vehicle.dampers[0].hydraulic->bleed = Fixed(1e-8);
  EXPECT_NE(LintDescription(vehicle).Format().find("at 0.1 m/s: are the two swapped?"), std::string::npos);
}

// A preload that nothing balances keeps the car from being assembled, but not from being looked at.
TEST_F(VehicleLintTest, LooksAtDescriptionsThatDoNotStand) {
  const std::optional<Vehicle> vehicle = Read(
      Replaced(kAxle, R"(name="tyre_right" link="wheel_right" xyz="0 0 0" radius="0.3 m" stiffness="200 kN/m")",
               R"(name="tyre_right" link="wheel_right" xyz="0 0 0" radius="0.3 m" stiffness="200 N/m" preload="9 N")"));
  ASSERT_TRUE(vehicle.has_value());
  EXPECT_THROW(LintAssembled(*vehicle), FaultyInput);
  EXPECT_THAT(LintDescription(*vehicle).Format(), HasSubstr("was 200 kN/m meant?"));
}

TEST(VehicleLint, TellsOfATyreAboveItsPlatform) {
  Vehicle vehicle = QuarterCar();
  vehicle.tyres[0].radius = 0.3;
  vehicle.tyres[0].point.xyz.z() = 0.015;
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
  vehicle.tyres[0].point.xyz.z() = -0.05;
  EXPECT_THAT(
      Findings(vehicle, vehicle.tyres[0].source_line),
      ElementsAre("the point of fp:tyre 'tyre' is 250 mm above the platform, z = 0, in the design pose, but its "
                  "radius is 300 mm: correct the joint's origin, the point or the radius"));
}

TEST(VehicleLint, TellsOfATyreBelowItsPlatform) {
  Vehicle vehicle = QuarterCar();
  vehicle.tyres[0].point.xyz.z() = -0.6;
  EXPECT_THAT(Findings(vehicle, vehicle.tyres[0].source_line), ElementsAre(HasSubstr("is -300 mm above the platform")));
}

TEST(VehicleLint, TellsOfLengths) {
  Vehicle vehicle = ShippedVehicle("single_wheel_station");
  vehicle.dampers[0].line.parent.xyz.z() = -0.39;
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre(HasSubstr("fp:damper 'damper' is 10 mm long in the design pose: its direction turns")));
  vehicle.dampers[0].line.parent.xyz.z() = 2.7;
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre("fp:damper 'damper' is 3.1 m long in the design pose: correct its ends"));
  vehicle.dampers[0].line.axis = Eigen::Vector3d::UnitZ();
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
}

TEST(VehicleLint, TellsThatThereIsNoPost) {
  Vehicle vehicle = QuarterCar();
  vehicle.posts.clear();
  EXPECT_THAT(Findings(vehicle, 0), ElementsAre(HasSubstr("the vehicle has tyres but no post")));
}

TEST_F(VehicleLintTest, TellsOfATyreWithoutAPost) {
  const std::string text = Replaced(kAxle, R"(<fp:post name="right" under="tyre_right"/>)", "");
  Look(text);
  ExpectWarning(text, "<fp:tyre name=\"tyre_right\"", "fp:tyre 'tyre_right' has no post while others have one");
}

TEST(VehicleLint, TellsThatThereIsNoSensor) {
  Vehicle vehicle = QuarterCar();
  vehicle.sensors.clear();
  EXPECT_THAT(Findings(vehicle, 0), ElementsAre(HasSubstr("the vehicle has no sensor")));
}

// A weight 50 mm outside the left wheel lifts the body off the right coil, another one the wheel as well.
TEST_F(VehicleLintTest, TellsOfSpringsAndTyresThatArePulled) {
  const std::string tilting = Replaced(kAxle, R"(<origin xyz="0 0 0"/>)", R"(<origin xyz="0 0.75 0"/>)");
  Look(tilting);
  // 500 kg x 9.80665 m/s^2 x 50 mm / 1.4 m = 175 N.
  ExpectWarning(tilting, R"(<fp:spring name="coil_right")", "fp:spring 'coil_right' is pulled with 175 N at rest");
  const std::string tilted = Replaced(kAxle, R"(<origin xyz="0 0 0"/>)", R"(<origin xyz="0 1 0"/>)");
  Look(tilted);
  ExpectWarning(tilted, R"(<fp:spring name="coil_right")", "fp:spring 'coil_right' is pulled with 1.05 kN at rest");
  // Less the wheel's weight of 392 N.
  ExpectWarning(tilted, R"(<fp:tyre name="tyre_right")", "fp:tyre 'tyre_right' pulls on its platform with 658 N");
}

TEST(VehicleLint, TellsOfAnAxisThatPointsTheWrongWay) {
  Vehicle vehicle = QuarterCar();
  vehicle.springs[0].line.axis = -Eigen::Vector3d::UnitZ();
  EXPECT_THAT(Findings(vehicle, vehicle.springs[0].source_line),
              ElementsAre(HasSubstr("and its axis, which points from child to parent")));
}

TEST(VehicleLint, TellsWhatElseCarriesTheWeight) {
  Vehicle vehicle = QuarterCar();
  Spring prop = vehicle.springs[0];
  prop.name = "prop";
  prop.line.child = {0, {0, 0, 0}};
  vehicle.springs.push_back(prop);
  EXPECT_THAT(Findings(vehicle, 0), ElementsAre(HasSubstr("the rest is on fp:spring 'prop'; free that")));
}

// A trailing arm hinged on the ground, its tyre half way between hinge and coil.
TEST(VehicleLint, TellsOfAJointThatCarriesTheWeight) {
  Vehicle vehicle = QuarterCar();
  vehicle.joints[0].type = Joint::Type::kRevolute;
  vehicle.joints[0].axis = Eigen::Vector3d::UnitY();
  vehicle.joints[0].pose.translation().x() = -1;
  vehicle.links[1].com[0].value = 1;
  vehicle.springs[0].line.child.xyz.x() = 1;
  vehicle.dampers[0].line.child.xyz.x() = 1;
  vehicle.tyres[0].point.xyz.x() = 0.5;
  for (Sensor& sensor : vehicle.sensors) sensor.point.xyz.x() = 0.5;
  EXPECT_THAT(Findings(vehicle, 0),
              ElementsAre("the tyres carry 4.35 kN at rest, but the vehicle weighs 2.18 kN: the rest is on joint "
                          "'wheel_travel', joint 'body_travel'; free that, or take the loads for those of a guided "
                          "vehicle"));
}

TEST_F(VehicleLintTest, TellsWhatNothingHoldsInThePlane) {
  const std::string text = Kart("damping=\"200 N*s/m\"");
  Look(text);
  ExpectWarning(text, "<link name=\"body\"",
                "nothing resists fore-aft motion of link 'body': give the tyres a longitudinal");
  ExpectWarning(text, "<link name=\"body\"", "nothing resists lateral motion of link 'body': give the tyres a lateral");
  ExpectWarning(text, "<link name=\"body\"", "nothing resists yaw of link 'body': give the tyres a lateral stiffness");
}

const std::string kPlaneDamping = "lateral_damping=\"500 N*s/m\" longitudinal_damping=\"100 N*s/m\" ";

TEST_F(VehicleLintTest, LetsDampedTyresHoldTheCar) {
  Look(Kart(kPlaneDamping + "damping=\"200 N*s/m\" lateral=\"80 kN/m\" longitudinal=\"20 kN/m\""));
}

// By hand: w^2 = 4 x 20 kN/m / 200 kg fore and aft, hence 3.18 Hz. The body carries the tyres, so it is
// the chassis.
TEST_F(VehicleLintTest, TellsOfMotionInThePlaneThatNothingDamps) {
  const std::string text = Kart("damping=\"200 N*s/m\" lateral=\"80 kN/m\" longitudinal=\"20 kN/m\"");
  Look(text);
  ExpectWarning(text, "<link name=\"body\"",
                "hardly anything damps the mode 'fore-aft' at 3.18 Hz (damping ratio 0 %): no measured car rings so, "
                "and a march hardly settles; give the tyres longitudinal_damping");
  ExpectWarning(text, "<link name=\"body\"", "mode 'lateral' at 6.37 Hz (damping ratio 0 %)");
  ExpectWarning(text, "<link name=\"body\"", "mode 'yaw' at 5.63 Hz");
}

// By hand: c / (2 m w) = 4 c / (2 x 200 kg x 20/s) is 0.5 % at c = 10 N*s/m.
TEST_F(VehicleLintTest, TellsOfDampingBelowHalfAPerCent) {
  const auto kart = [](const std::string& along) {
    return Kart(
        "damping=\"200 N*s/m\" lateral=\"80 kN/m\" longitudinal=\"20 kN/m\" lateral_damping=\"500 N*s/m\" "
        "longitudinal_damping=\"" +
        along + " N*s/m\"");
  };
  Look(kart("10.1"));
  Look(kart("9.9"));
  ExpectWarning(kart("9.9"), "<link name=\"body\"", "mode 'fore-aft' at 3.18 Hz (damping ratio 0.495 %)");
}

TEST_F(VehicleLintTest, TellsOfRideThatNothingDamps) {
  const std::string text = Kart(kPlaneDamping + "lateral=\"80 kN/m\" longitudinal=\"20 kN/m\"");
  Look(text);
  ExpectWarning(text, "<link name=\"body\"", "mode 'heave' at 7.12 Hz (damping ratio 0 %)");
  ExpectWarning(text, "<link name=\"body\"", "mode 'roll' at 9.19 Hz");
  ExpectWarning(text, "<link name=\"body\"",
                "mode 'pitch' at 6.5 Hz (damping ratio 0 %): no measured car rings so, and a march hardly settles; add "
                "an fp:damper, or damping to a bushing or tyre");
}

// Fore-aft at sqrt(4 x 2 MN/m / 200 kg) = 31.8 Hz.
TEST_F(VehicleLintTest, LeavesModesAboveTheRigAlone) {
  Look(Kart("lateral_damping=\"5 kN*s/m\" damping=\"200 N*s/m\" lateral=\"80 kN/m\" longitudinal=\"2 MN/m\""));
}

TEST_F(VehicleLintTest, TellsOnceWhatATwinHasAsWell) {
  const std::string bare = Kart(kPlaneDamping + "damping=\"200 N*s/m\" lateral=\"80 kN/m\" longitudinal=\"20 kN/m\"");
  const std::string mirrored = R"(<fp:mirror from="_left" to="_right"/>
<fp:frame name="end_left" link="body" xyz="0 0.4 0.3"/>
<fp:frame name="rig_left" link="ground" xyz="0 0.4 1"/>
<fp:spring name="tie_left" parent="rig_left" child="end_left"><linear stiffness="9 N/m" preload="0 N"/></fp:spring>
</robot>)";
  const std::string text = Replaced(bare, "</robot>", mirrored);
  Look(text);
  ExpectWarning(text, "<fp:spring name=\"tie_left\"", "stiffness of fp:spring 'tie_left' is 9 N/m");
}

TEST_F(VehicleLintTest, TellsOfABarWithBothLinesOnOneSide) {
  const std::string text = Replaced(kAxle, R"(<right parent="body" child="wheel_right"/>)",
                                    R"(<right parent="top_left" child="wheel_left"/>)");
  Look(text);
  ExpectWarning(text, "<fp:antiroll", "both lines of fp:antiroll 'bar' are on the left of the car");
}

// 10 mm: 30 kN/m makes 300 N, 4e10 N/m^3 40 kN.
TEST_F(VehicleLintTest, TellsOfCubicTermsThatOutdoTheLinearOnes) {
  const auto text = [](const std::string& cubic) {
    std::string cubics = kAxle;
    for (const std::string side : {"left", "right"}) {
      const std::string coil =
          "<fp:spring name=\"coil_" + side + "\" parent=\"top_" + side + "\" child=\"wheel_" + side + "\">";
      cubics = Replaced(cubics, coil + "<linear stiffness=\"30 kN/m\"/>",
                        coil + "<cubic stiffness=\"30 kN/m\" cubic=\"" + cubic + "\"/>");
    }
    return cubics;
  };
  Look(text("2.9e10 N/m^3"));
  Look(text("40 N/mm^3"));
  for (const std::string side : {"left", "right"})
    ExpectWarning(text("40 N/mm^3"), "<fp:spring name=\"coil_" + side,
                  "cubic of fp:spring 'coil_" + side + "' makes 40 kN at 10 mm, its stiffness 300 N");
}

TEST(VehicleLint, TellsOfASeriesSpringAsStiffAsARock) {
  Vehicle vehicle = QuarterCar();
  vehicle.dampers[0].series = SpringDescription{.stiffness = {.value = 400e6}, .cubic = {}, .knees = {}};
  EXPECT_THAT(
      Findings(vehicle, vehicle.dampers[0].source_line),
      ElementsAre(HasSubstr("series stiffness of fp:damper 'damper' is 400 MN/m, not within 10 kN/m to 100 MN/m; "
                            "was 400 kN/m meant?")));
}

// A bench finds 500 N/mm and 20 kN/mm^3: at 1 mm 500 N and 20 kN.
TEST(VehicleLint, TakesAHardeningSeriesSpringForUsual) {
  Vehicle vehicle = QuarterCar();
  SpringDescription series{.stiffness = {.value = 500e3}, .cubic = {.value = 2e13}, .knees = {}};
  vehicle.dampers[0].series = series;
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line), IsEmpty());
  series.cubic.value = 2e14;
  vehicle.dampers[0].series = series;
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre(HasSubstr("the series spring of fp:damper 'damper' makes 200 kN at 1 mm")));
}

TEST(VehicleLint, TakesFrictionForDamping) {
  Vehicle vehicle = QuarterCar();
  vehicle.dampers[0].law = {};
  vehicle.dampers[0].law.friction = {.force = {.value = 90}, .speed = {.value = 0.002}};
  vehicle.parameters.resize(4);  // all but the damper's
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
}

TEST_F(VehicleLintTest, TellsOfAParameterThatChangesNothing) {
  const std::string parameter = R"(<fp:parameter name="I_wheel" value="1 kg*m^2" source="estimate">)"
                                R"(<fp:bind to="link[wheel_left]/inertia/izz"/></fp:parameter>)";
  const std::string text = Replaced(kAxle, "</robot>", parameter + "\n</robot>");
  Look(text);
  ExpectWarning(text, parameter, "fp:parameter 'I_wheel' changes neither the motion nor a static load");
}

// What the condensed model does not know of may matter to the march.
TEST_F(VehicleLintTest, LeavesParametersOfCurvedLawsAlone) {
  Look(Replaced(kAxle, "</robot>", R"(<fp:parameter name="gap" value="60 mm" source="estimate"/>
<fp:stop name="stop" parent="top_left" child="wheel_left"><bump gap="$gap" stiffness="200 kN/m"/></fp:stop></robot>)"));
}

}  // namespace
}  // namespace fourpost
