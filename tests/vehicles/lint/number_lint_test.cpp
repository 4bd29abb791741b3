#include "vehicles/lint/number_lint.h"

#include <ostream>

#include <gmock/gmock.h>

#include "tests/vehicles/lint/odd_vehicle.h"
#include "vehicles/description/drawn_vehicle.h"
#include "vehicles/lint/findings.h"

namespace fourpost::number_lint_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(VehicleLint, TellsOfATyreInNewtonsPerMetre) {
  Vehicle vehicle = DampedQuarterCar();
  Set(vehicle, "kt", 230);
  EXPECT_THAT(Findings(vehicle, vehicle.tyres[0].source_line),
              ElementsAre(IsFinding(kNumberUnusual,
                                    {"stiffness", "fp:tyre 'tyre'", "0.23 kN/m", "20 kN/m", "2 MN/m", "230 kN/m"})));
}

TEST(VehicleLint, TellsOfASpringInNewtonsPerMetre) {
  Vehicle vehicle = ShippedQuarterCar();
  Set(vehicle, "k", 15);
  EXPECT_THAT(Findings(vehicle, vehicle.springs[0].source_line),
              ElementsAre(IsFinding(kNumberUnusual,
                                    {"stiffness", "fp:spring 'spring'", "0.015 kN/m", "1 kN/m", "1 MN/m", "15 kN/m"})));
}

TEST(VehicleLint, TellsOfADamperInKilonewtons) {
  Vehicle vehicle = DampedQuarterCar();
  Set(vehicle, "c_bump", 1.5e6);
  Set(vehicle, "c_rebound", 1.5e6);
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre(IsFinding(kNumberUnusual, {"bump rate", "fp:damper 'damper'"}),
                          IsFinding(kNumberUnusual, {"1.5 kN*s/m"})));
}

TEST(VehicleLint, TellsOfATyreDampedInKilonewtons) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.tyres[0].damping = {.value = 150e3};
  EXPECT_THAT(
      Findings(vehicle, vehicle.tyres[0].source_line),
      ElementsAre(IsFinding(kNumberUnusual, {"damping", "fp:tyre 'tyre'", "150 kN*s/m", "20 kN*s/m", "150 N*s/m"})));
}

TEST(VehicleLint, TellsOfMasses) {
  Vehicle light = ShippedQuarterCar();
  Set(light, "m_unsprung", 22e-5);
  EXPECT_THAT(Findings(light, light.links[1].line), ElementsAre(IsFinding(kNumberUnusual, {"220 g"})));
  Vehicle heavy = ShippedQuarterCar();
  Set(heavy, "m_sprung", 2e5);
  EXPECT_THAT(Findings(heavy, heavy.links[2].line),
              ElementsAre(IsFinding(kNumberUnusual, {"mass", "link 'sprung'", "200000 kg", "1 g", "100 t", "200 kg"})));
}

TEST(VehicleLint, TellsOfABushingAsStiffAsARock) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.bushings.push_back({.name = "mount", .parent = {2, {0, 0, 0}}, .child = {1, {0, 0, 0.4}}, .source_line = 7});
  vehicle.bushings[0].stiffness[1].value = 0.9e9;
  EXPECT_THAT(Findings(vehicle, 7), IsEmpty());
  vehicle.bushings[0].stiffness[1].value = 3e9;
  EXPECT_THAT(Findings(vehicle, 7),
              ElementsAre(IsFinding(kNumberUnusual, {"stiffness along y", "fp:bushing 'mount'", "3000 MN/m"})));
}

TEST(VehicleLint, TellsOfATyresRadius) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.tyres[0].radius = 2.5;
  vehicle.tyres[0].point.xyz.z() = 2.2;
  EXPECT_THAT(Findings(vehicle, vehicle.tyres[0].source_line),
              ElementsAre(IsFinding(kNumberFarOff, {"radius", "fp:tyre 'tyre'", "2.5 m", "100 mm", "2 m"})));
}

TEST(VehicleLint, TellsOfMillimetres) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.dampers[0].line.parent.xyz.y() = 350;
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre(IsFinding(kPlaceInMillimetres, {"parent's end", "fp:damper 'damper'", "350 m", "350 mm"})));
}

TEST(VehicleLint, TellsOfAJointsOriginInMillimetres) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.joints[1].pose.translation().y() = 700;
  EXPECT_THAT(Findings(vehicle, vehicle.joints[1].line),
              ElementsAre(IsFinding(kPlaceInMillimetres, {"joint 'body_travel'", "700 m"})));
}

Spring Stop(double bump_m, double rebound_m) {
  Spring stop = ShippedQuarterCar().springs[0];
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
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.springs.push_back(Stop(0, 0));
  EXPECT_THAT(Findings(vehicle, vehicle.springs[1].source_line),
              ElementsAre(IsFinding(kStopWithoutGap, {"fp:stop 'stop'"})));
  vehicle.springs[1] = Stop(0, 0.1);
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
}

TEST(VehicleLint, TellsOfSwappedDamping) {
  Vehicle vehicle = ShippedQuarterCar();
  Set(vehicle, "c_rebound", 200);
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre(IsFinding(kDampingSwapped, {"fp:damper 'damper'", "1.5 kN*s/m", "200 N*s/m"})));
  Set(vehicle, "c_rebound", 400);
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
}

/// A number of a quarter car that no vehicle has.
struct OddNumber {
  std::string name;
  void (*change)(Vehicle& vehicle);
  const Finding& kind;
  std::vector<std::string> words;
};

std::ostream& operator<<(std::ostream& out, const OddNumber& odd) { return out << odd.name; }

Scalar Fixed(double value) { return {.value = value}; }

DashpotDescription MeasuredCurve(double speed_mps) {
  return {.kind = DashpotDescription::Kind::kTable,
          .compression = {},
          .rebound = {},
          .table = {{Fixed(-speed_mps), Fixed(-900)}, {Fixed(0), Fixed(0)}, {Fixed(speed_mps), Fixed(1500)}}};
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
     kNumberUnusual,
     {"friction", "fp:damper 'damper'", "25 kN", "0.1 N", "5 kN", "25 N"}},
    {"friction_speed",
     [](Vehicle& car) {
       car.dampers[0].law.friction = {Fixed(25), Fixed(2)};
     },
     kNumberUnusual,
     {"friction speed", "fp:damper 'damper'", "2 m/s", "0.0001 m/s", "0.1 m/s", "0.002 m/s"}},
    {"series",
     [](Vehicle& car) { car.dampers[0].series = SpringDescription{.stiffness = Fixed(0.4)}; },
     kNumberUnusual,
     {"series stiffness", "fp:damper 'damper'", "0.4 N/m"}},
    {"stop",
     [](Vehicle& car) { car.springs[1].law.knees[0].rate = Fixed(80); },
     kNumberUnusual,
     {"bump stiffness", "fp:stop 'stop'", "80 N/m", "1 kN/m", "100 MN/m", "80 kN/m"}},
    {"gap",
     [](Vehicle& car) { car.springs[1].law.knees[0].at = Fixed(30); },
     kNumberUnusual,
     {"bump gap", "fp:stop 'stop'", "30 m", "0.1 mm", "500 mm", "30 mm"}},
    {"knee",
     [](Vehicle& car) {
       car.springs[0].law.knees = {{-1, Fixed(2), Fixed(3e4), {}, false}};
     },
     kNumberUnusual,
     {"place of bump knee 1", "fp:spring 'spring'", "1", "2 m"}},
    {"knee_rate",
     [](Vehicle& car) {
       car.springs[0].law.knees = {{-1, Fixed(0.02), Fixed(30), {}, false}};
     },
     kNumberUnusual,
     {"stiffness beyond bump knee 1", "fp:spring 'spring'", "1", "30 N/m"}},
    {"knee_speed",
     [](Vehicle& car) {
       car.dampers[0].law.kind = DashpotDescription::Kind::kDigressive;
       car.dampers[0].law.compression_knee = {Fixed(150), Fixed(500)};
       car.dampers[0].law.rebound_knee = {Fixed(0.15), Fixed(500)};
     },
     kNumberUnusual,
     {"bump knee", "fp:damper 'damper'", "150 m/s", "0.001 m/s", "5 m/s", "0.15 m/s"}},
    {"lateral",
     [](Vehicle& car) { car.tyres[0].lateral = Fixed(90); },
     kNumberUnusual,
     {"lateral stiffness", "fp:tyre 'tyre'", "90 N/m"}},
    {"tyre_damping",
     [](Vehicle& car) { car.tyres[0].damping = Fixed(100e3); },
     kNumberUnusual,
     {"damping", "fp:tyre 'tyre'", "100 kN*s/m", "20 kN*s/m", "100 N*s/m"}},
    {"wheelpan",
     [](Vehicle& car) {
       car.sensors.push_back({.name = "F", .type = Sensor::Type::kLoadCell, .tyre = 0, .wheelpan = Fixed(25e3)});
     },
     kNumberUnusual,
     {"wheelpan", "fp:sensor 'F'", "25 t", "10 g", "1 t", "25 kg"}},
    {"table",
     [](Vehicle& car) { car.dampers[0].law = MeasuredCurve(500); },
     kNumberUnusual,
     {"speed in the table", "fp:damper 'damper'", "-500 m/s", "10 m/s", "-0.5 m/s"}},
    {"mean_rate",
     [](Vehicle& car) { car.dampers[0].law = MeasuredCurve(0.001); },
     kMeanRateUnusual,
     {"fp:damper 'damper'", "0.1 m/s", "1.2", "10 N*s/m", "100 kN*s/m", "1.2 kN*s/m"}},
    {"bleed",
     [](Vehicle& car) {
       car.dampers[0].hydraulic = Oil();
       car.dampers[0].hydraulic->bleed = Fixed(3);
     },
     kNumberUnusual,
     {"bleed", "fp:damper 'damper'", "3", "2"}},
    {"piston",
     [](Vehicle& car) {
       car.dampers[0].hydraulic = Oil();
       car.dampers[0].hydraulic->piston_diameter = Fixed(0.3);
     },
     kNumberFarOff,
     {"piston", "fp:damper 'damper'", "300 mm", "10 mm", "150 mm"}},
    {"valve",
     [](Vehicle& car) {
       car.dampers[0].hydraulic = Oil();
       car.dampers[0].hydraulic->compression_valve = Fixed(10);
     },
     kNumberUnusual,
     {"bump_valve", "fp:damper 'damper'", "10"}},
    {"gas_volume",
     [](Vehicle& car) {
       car.dampers[0].hydraulic = Oil();
       car.dampers[0].hydraulic->gas_volume = Fixed(60);
     },
     kNumberUnusual,
     {"gas_volume", "fp:damper 'damper'", "60", "3"}},
    {"antiroll",
     [](Vehicle& car) {
       ForceLine to_ground = car.springs[0].line;
       to_ground.child.link = 0;
       car.antiroll_bars.push_back(
           {.name = "bar", .left = car.springs[0].line, .right = to_ground, .stiffness = Fixed(0.06)});
     },
     kNumberUnusual,
     {"stiffness", "fp:antiroll 'bar'", "0.06 N/m", "100 N/m", "10 MN/m"}},
};

class OddNumbers : public testing::TestWithParam<OddNumber> {};

TEST_P(OddNumbers, AreTold) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.springs.push_back(Stop(0.03, 0.05));
  EXPECT_EQ(LintDescription(vehicle).Format(), "");
  GetParam().change(vehicle);
  EXPECT_THAT(LintDescription(vehicle), Reports(GetParam().kind, GetParam().words));
}

INSTANTIATE_TEST_SUITE_P(All, OddNumbers, testing::ValuesIn(kOddNumbers),
                         [](const auto& test) { return test.param.name; });

TEST(VehicleLint, TakesOilAndMeasuredCurvesForUsual) {
  Vehicle vehicle = ShippedQuarterCar();
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
  EXPECT_THAT(LintDescription(vehicle), Reports(kGapBeyondLength));
}

TEST(VehicleLint, TellsOfAPistonThatMeetsItsEndBeforeTheStop) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.springs.push_back(Stop(0.03, 0.05));
  vehicle.dampers[0].hydraulic = Oil();
  vehicle.dampers[0].hydraulic->rebound_column = Fixed(0.04);
  vehicle.parameters.resize(4);  // all but the damper's
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre(IsFinding(kOilColumnShort, {"fp:damper 'damper'", "fp:stop 'stop'", "40 mm", "50 mm"})));
}

TEST(VehicleLint, TellsOfSwappedDampingInATable) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.dampers[0].law = MeasuredCurve(0.1);
  vehicle.dampers[0].law.table[0].force = Fixed(-8 * 1500);
  vehicle.parameters.resize(4);  // all but the damper's
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre(IsFinding(kDampingSwapped, {"fp:damper 'damper'", "120 kN*s/m", "15 kN*s/m", "0.1 m/s"})));
}

TEST(VehicleLint, TellsOfSwappedDampingInAHydraulicDamper) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.dampers[0].hydraulic = Oil();
  std::swap(vehicle.dampers[0].hydraulic->rebound_valve, vehicle.dampers[0].hydraulic->compression_valve);
  vehicle.dampers[0].hydraulic->bleed = Fixed(1e-5);
  vehicle.dampers[0].hydraulic->compression_valve = Fixed(5e7);
  vehicle.dampers[0].hydraulic->rebound_valve = Fixed(1e6);
  EXPECT_EQ(LintDescription(vehicle).Format(), "");  // with this bleed the valves barely matter
  vehicle.dampers[0].hydraulic->bleed = Fixed(1e-8);
  EXPECT_THAT(LintDescription(vehicle), Reports(kDampingSwapped, {"at 0.1 m/s"}));
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
    ExpectWarning(text("40 N/mm^3"), "<fp:spring name=\"coil_" + side, kCubicDominates,
                  {"fp:spring 'coil_" + side + "'", "40 kN", "10 mm", "300 N"});
}

TEST(VehicleLint, TellsOfASeriesSpringAsStiffAsARock) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.dampers[0].series = SpringDescription{.stiffness = {.value = 400e6}, .cubic = {}, .knees = {}};
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre(IsFinding(kNumberUnusual, {"series stiffness", "fp:damper 'damper'", "400 MN/m", "10 kN/m",
                                                     "100 MN/m", "400 kN/m"})));
}

// A bench finds 500 N/mm and 20 kN/mm^3: at 1 mm 500 N and 20 kN.
TEST(VehicleLint, TakesAHardeningSeriesSpringForUsual) {
  Vehicle vehicle = ShippedQuarterCar();
  SpringDescription series{.stiffness = {.value = 500e3}, .cubic = {.value = 2e13}, .knees = {}};
  vehicle.dampers[0].series = series;
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line), IsEmpty());
  series.cubic.value = 2e14;
  vehicle.dampers[0].series = series;
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre(IsFinding(kCubicDominates, {"fp:damper 'damper'", "200 kN", "1 mm"})));
}

TEST(VehicleLint, TakesFrictionForDamping) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.dampers[0].law = {};
  vehicle.dampers[0].law.friction = {.force = {.value = 90}, .speed = {.value = 0.002}};
  vehicle.parameters.resize(4);  // all but the damper's
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
}

}  // namespace
}  // namespace fourpost::number_lint_test
