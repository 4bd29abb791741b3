#include "vehicles/reader/file_tags.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/temporary_folder.h"
#include "tests/vehicles/curves/property_samples.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/curves/findings.h"
#include "vehicles/reader/damper_text.h"
#include "vehicles/reader/findings.h"
#include "vehicles/tags/findings.h"

namespace fourpost::file_tags_test {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string kCoil =
    R"(<fp:spring name="coil" parent="top" child="wheel" axis="0 0 2"><linear stiffness="0.5*$k" preload="-2 kN"/></fp:spring>)";
const std::string kHelper = R"(<linear stiffness="$k"/></fp:spring>)";
const std::string kHub = R"(<linear rate="10 N*s/m"/>)";
const std::string kCoilTable = "extension [mm],force [kN]\n-100,-3\n-50,-1\n0,0\n20,0.2\n";
const std::string kTyreTable = "deflection [mm],force [kN]\n0,0\n10,1.9\n30,6.3\n";
const std::string kShockTable = "speed [m/s],force [N]\n-1,-900\n0.1,300\n1,2000\n";

class FileTags : public VehicleFileTest {
 protected:
  FileTags() {
    Write(kCoilTable, "coil.csv");
    Write(kShockTable, "shock.csv");
    Write(kTyreTable, "tyre.csv");
    Write(kSpringFile, "coil.spr");
    Write(kTyreFile, "tyre.tir");
    Write(kDamperFile, "shock.dpr");
    Write(kBushingFile, "arm.bus");
  }

  static std::string WithSpring(const std::string& table) {
    return Replaced(kSmallVehicle, kHelper, table + "</fp:spring>");
  }
  static std::string WithDamper(const std::string& table) { return Replaced(kSmallVehicle, kHub, table); }

  static std::string WithTyre(const std::string& table) {
    return Replaced(kSmallVehicle, R"(stiffness="200 kN/m" damping="50 N*s/m" preload="2 kN"/>)",
                    R"(damping="50 N*s/m" preload="2 kN">)" + table + "</fp:tyre>");
  }

  static TyreLaw LawOfTyre(const Vehicle& vehicle) { return vehicle.tyres.at(0).law.At(vehicle.ParameterValues()); }
  static SpringLaw Helper(const Vehicle& vehicle) { return vehicle.springs.at(1).law.At(vehicle.ParameterValues()); }
  static DashpotLaw Hub(const Vehicle& vehicle) { return vehicle.dampers.at(1).law.At(vehicle.ParameterValues()); }

  /// The vehicle as it is written into another folder, where none of its files are.
  Vehicle Moved(const Vehicle& vehicle) {
    const TemporaryFolder other;
    const std::string text = VehicleTextWithValues(vehicle, vehicle.ParameterValues(), other.path());
    EXPECT_THAT(text, Not(HasSubstr("file=")));
    return ReadVehicle(other.Write("moved.urdf", text), diagnostics_).value();
  }
};

TEST_F(FileTags, AreAsIfWrittenOut) {
  const std::optional<Vehicle> written = Read(WithSpring(R"(<table at="-50 mm">
    <point extension="-100 mm" force="-3 kN"/><point extension="-50 mm" force="-1 kN"/>
    <point extension="0 mm" force="0 N"/><point extension="20 mm" force="0.2 kN"/></table>)"));
  const std::optional<Vehicle> named = Read(WithSpring(R"(<table at="-50 mm" file="coil.csv"/>)"));
  ASSERT_TRUE(written && named);
  EXPECT_EQ(Helper(*named), Helper(*written));
  const std::optional<Vehicle> damper = Read(WithDamper(R"(<table file="shock.csv"/>)"));
  const std::optional<Vehicle> points = Read(WithDamper(R"(<table><point speed="-1 m/s" force="-900 N"/>
    <point speed="0.1 m/s" force="300 N"/><point speed="1 m/s" force="2 kN"/></table>)"));
  ASSERT_TRUE(damper && points);
  EXPECT_EQ(Hub(*damper), Hub(*points));
}

TEST_F(FileTags, GiveATyreItsLoadDeflectionCurve) {
  const std::optional<Vehicle> written = Read(WithTyre(R"(<table scale="1.5"><point deflection="0 mm" force="0 N"/>
    <point deflection="10 mm" force="1.9 kN"/><point deflection="30 mm" force="6.3 kN"/></table>)"));
  ASSERT_TRUE(written) << diagnostics_.Format();
  EXPECT_DOUBLE_EQ(LawOfTyre(*written).Force(0.01), 1.5 * 1900);
  EXPECT_TRUE(written->tyres[0].lifts_off);
  for (const char* file : {"tyre.csv", "tyre.tir"}) {
    const std::optional<Vehicle> named = Read(WithTyre(R"(<table scale="1.5" file=")" + std::string(file) + R"("/>)"));
    ASSERT_TRUE(named) << diagnostics_.Format();
    EXPECT_EQ(LawOfTyre(*named), LawOfTyre(*written)) << file;
    EXPECT_EQ(LawOfTyre(Moved(*named)), LawOfTyre(*written)) << file;
  }
}

TEST_F(FileTags, ScaleTheCurve) {
  const std::optional<Vehicle> vehicle = Read(WithDamper(R"(<table file="shock.csv" scale="1.5"/>)"));
  ASSERT_TRUE(vehicle);
  EXPECT_DOUBLE_EQ(Hub(*vehicle).Force(1), 3000);
  std::string text = WithSpring(R"(<table at="-50 mm" file="coil.csv" scale="0.5*$coil"/>)");
  text = Replaced(
      text, "  <fp:frame name=\"top\"",
      "  <fp:parameter name=\"coil\" value=\"2\" lower=\"1\" upper=\"3\" precision=\"0.01\" source=\"bench\"/>\n"
      "  <fp:frame name=\"top\"");
  const std::optional<Vehicle> scaled = Read(text);
  ASSERT_TRUE(scaled) << diagnostics_.Format();
  std::vector<double> values = scaled->ParameterValues();
  EXPECT_DOUBLE_EQ(scaled->springs.at(1).law.At(values).Force(-0.05), -2000);
  values.back() = 3;
  EXPECT_DOUBLE_EQ(scaled->springs.at(1).law.At(values).Force(-0.05), -3000);
}

TEST_F(FileTags, RefuseTwoParametersInAForce) {
  std::string text = WithDamper(
      "<table scale=\"$a\">\n<point speed=\"1 m/s\" force=\"$f\"/>\n<point speed=\"2 m/s\" force=\"2*$f\"/></table>");
  text = Replaced(text, "  <fp:frame name=\"top\"",
                  "  <fp:parameter name=\"a\" value=\"2\" source=\"bench\"/><fp:parameter name=\"f\" value=\"2 N\" "
                  "source=\"bench\"/>\n"
                  "  <fp:frame name=\"top\"");
  EXPECT_FALSE(Read(text));
  Expect(LineOf(text, "force=\"$f\""), kScaleTwice, {"force=\"$f\"", "scale=\"$a\""});
  Expect(LineOf(text, "force=\"2*$f\""), kScaleTwice, {"force=\"2*$f\""});
}

// The helper hangs between (0.1, 0, 0.4) of the body, at z = 0.8 and turned by a quarter, and the ground's origin.
TEST_F(FileTags, PlaceASpringByTheFreeLengthOfItsFile) {
  const double length = std::hypot(0.1, 1.2);
  Write(Replace(kSpringFile, "320.0", "1250.0"), "coil.spr");
  const std::optional<Vehicle> vehicle = Read(WithSpring(R"(<table file="coil.spr"/>)"));
  ASSERT_TRUE(vehicle) << diagnostics_.Format();
  // Of a sum of lengths of a metre, in rounding.
  EXPECT_NEAR(vehicle->springs.at(1).law.place.value, length - 1.25, 1e-15);
  // From free to 60 mm pushed together, as the file has it, in rounding.
  const double at = length - 1.25;
  EXPECT_NEAR(Helper(*vehicle).Force(-at) - Helper(*vehicle).Force(-0.06 - at), 1800, 1e-9);
  const Vehicle moved = Moved(*vehicle);
  EXPECT_EQ(Helper(moved), Helper(*vehicle));
  EXPECT_EQ(moved.springs.at(1).law.place.value, vehicle->springs.at(1).law.place.value);
}

TEST_F(FileTags, WarnOfASpringBeyondItsCurve) {
  const std::string text = WithSpring(R"(<table file="coil.spr"/>)");
  EXPECT_TRUE(Read(text));
  Expect(LineOf(text, "<fp:spring name=\"helper\""), kCurvePlace, {"320 mm", "-120 mm", "50 mm"});
  const std::string table = WithSpring(R"(<table file="far.csv"/>)");
  Write("extension [mm],force [N]\n-100,-3\n-50,-1\n", "far.csv");
  EXPECT_TRUE(Read(table));
  Expect(LineOf(table, "<fp:spring name=\"helper\""), kSpringTablePlace);
}

TEST_F(FileTags, AskForThePlaceOfAGuidedSpring) {
  const std::string guided = Replaced(
      kSmallVehicle, kCoil,
      R"(<fp:spring name="coil" parent="top" child="wheel" axis="0 0 2"><table file="coil.spr"/></fp:spring>)");
  EXPECT_FALSE(Read(guided));
  Expect(LineOf(guided, "<fp:spring name=\"coil\""), kCurvePlaceGuided);
  EXPECT_TRUE(Read(Replaced(guided, R"(file="coil.spr")", R"(at="-60 mm" file="coil.spr")")));
}

TEST_F(FileTags, GiveABushingItsRates) {
  const auto with = [](const std::string& bushing) {
    return Replaced(kSmallVehicle, "  <fp:rod", "  " + bushing + "\n  <fp:rod");
  };
  const std::optional<Vehicle> vehicle = Read(with(
      R"(<fp:bushing name="arm" parent="top" child="wheel" file="arm.bus"><translation x="1 kN/mm" y="$k" z="0 N/m"/></fp:bushing>)"));
  ASSERT_TRUE(vehicle) << diagnostics_.Format();
  const Bushing& bushing = vehicle->bushings.at(0);
  // What is written out stands.
  EXPECT_EQ(bushing.stiffness[0].value, 1e6);
  EXPECT_EQ(bushing.stiffness[1].value, 15e3);
  EXPECT_EQ(bushing.damping[1].value, 3e3);
  EXPECT_NEAR(bushing.stiffness[4].value, 4 * 180 / std::numbers::pi, 1e-9);
  const Vehicle moved = Moved(*vehicle);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(moved.bushings.at(0).stiffness[i].value, bushing.stiffness[i].value) << i;
    EXPECT_EQ(moved.bushings.at(0).damping[i].value, bushing.damping[i].value) << i;
  }
}

TEST_F(FileTags, StayNamedBesideTheirFiles) {
  const std::string text = WithDamper(R"(<table file="shock.dpr" scale="2"></table>)");
  const std::optional<Vehicle> vehicle = Read(text);
  ASSERT_TRUE(vehicle) << diagnostics_.Format();
  EXPECT_EQ(VehicleTextWithValues(*vehicle, vehicle->ParameterValues(), folder_), text);
  EXPECT_EQ(Hub(Moved(*vehicle)), Hub(*vehicle));
  // As it was read.
  std::filesystem::remove(folder_ / "shock.dpr");
  EXPECT_EQ(Hub(Moved(*vehicle)), Hub(*vehicle));
  EXPECT_THAT(DamperText(*vehicle, "hub", vehicle->ParameterValues()),
              testing::AllOf(HasSubstr(R"(<point speed="0.5 m/s" force="2400 N"/>)"), Not(HasSubstr("file="))));
}

TEST_F(FileTags, AreMirrored) {
  std::string text = Replaced(kSmallVehicle, "  <fp:rod",
                              R"(  <fp:mirror from="_left" to="_right"/>
  <fp:frame name="arm_left" link="body" xyz="0 0.3 0.2"/><fp:frame name="seat_left" link="wheel" xyz="0 0.3 -0.1"/>
  <fp:spring name="side_left" parent="arm_left" child="seat_left"><table file="side.spr"/></fp:spring>
  <fp:damper name="side_left" parent="arm_left" child="seat_left"><table file="shock.dpr"/></fp:damper>
  <fp:rod)");
  Write(Replace(kSpringFile, "320.0", "950.0"), "side.spr");
  const std::optional<Vehicle> vehicle = Read(text);
  ASSERT_TRUE(vehicle) << diagnostics_.Format();
  ASSERT_EQ(vehicle->springs.size(), 4U);
  for (const Vehicle& one : {*vehicle, Moved(*vehicle)}) {
    EXPECT_EQ(one.springs[2].law.At(one.ParameterValues()), one.springs[3].law.At(one.ParameterValues()));
    EXPECT_EQ(one.springs[3].law.place.value, vehicle->springs[2].law.place.value);
    EXPECT_EQ(one.dampers[3].law.At(one.ParameterValues()), Hub(*Read(WithDamper(R"(<table file="shock.dpr"/>)"))));
  }
}

TEST_F(FileTags, ReportFilesThatAreMissing) {
  const std::string text = Replaced(WithSpring(R"(<table file="coil.scv"/>)"), kHub, "\n<table file=\" \"/>");
  EXPECT_FALSE(Read(text));
  Expect(LineOf(text, "file=\"coil.scv\""), kFileMissing, {"coil.scv", folder_.string()});
  Expect(LineOf(text, "file=\" \""), kAttributeEmpty);
}

TEST_F(FileTags, ReportFilesWithPointsBeside) {
  const std::string text = WithDamper(
      R"(<table file="shock.csv"><point speed="1 m/s" force="2 kN"/><point speed="2 m/s" force="3 kN"/></table>)");
  EXPECT_FALSE(Read(text));
  Expect(LineOf(text, "file=\"shock.csv\""), kFileAndPoints);
}

// A small file that names a curve often must not take the memory.
TEST_F(FileTags, GiveNoMoreTagsThanAVehicleFileHas) {
  std::string curve = "speed [m/s],force [N]\n";
  for (int i = 1; i <= 1000; ++i) curve += std::to_string(i) + "," + std::to_string(i) + "\n";
  Write(curve, "long.csv");
  std::string dampers;
  for (int i = 0; i < 205; ++i)
    dampers += "\n  <fp:damper name=\"d" + std::to_string(i) +
               R"(" parent="top" child="wheel"><table file="long.csv"/></fp:damper>)";
  const std::string text = Replaced(kSmallVehicle, "  <fp:rod", "  " + dampers + "\n  <fp:rod");
  EXPECT_FALSE(Read(text));
  Expect(LineOf(text, "name=\"d200\""), kFileTags, {"200000"});
}

// In its own file and line, once for all that name it.
TEST_F(FileTags, ReportFaultsOfTheFile) {
  Write("speed [m/s],force [N]\n-1,900\n0.1,300\n1,200\n", "shock.csv");
  EXPECT_FALSE(
      Read(Replaced(WithDamper(R"(<table file="shock.csv"/>)"), R"(<bilinear bump="1 kN*s/m" rebound="2 kN*s/m"/>
    <series stiffness="800 N/mm"/>)",
                    R"(<table file="shock.csv"/>)")));
  ASSERT_EQ(diagnostics_.items().size(), 1U) << diagnostics_.Format();
  EXPECT_EQ(diagnostics_.items()[0].id, kCurvePushes.id());
  EXPECT_EQ(diagnostics_.items()[0].place.file, folder_ / "shock.csv");
  EXPECT_EQ(diagnostics_.items()[0].place.line, 2);
  diagnostics_ = {};
}

}  // namespace
}  // namespace fourpost::file_tags_test
