#include "vehicles/chrono/chrono_text.h"

#include <cmath>
#include <filesystem>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/findings.h"
#include "tests/temporary_folder.h"
#include "vehicles/chrono/chrono_axle.h"
#include "vehicles/chrono/chrono_vehicle.h"
#include "vehicles/chrono/findings.h"
#include "vehicles/description/gravity.h"
#include "vehicles/lint/vehicle_lint.h"
#include "vehicles/poses/settled_pose.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost::chrono_text_test {
namespace {

namespace fs = std::filesystem;

const fs::path kSamples = fs::path(FOURPOST_SOURCE_DIR) / "tests/data/chrono";

class ChronoText : public testing::Test {
 protected:
  ChronoText() { fs::copy(kSamples, folder_.path(), fs::copy_options::recursive); }

  /// Replaces the only `from` of a file.
  void Change(const std::string& file, const std::string& from, const std::string& to) {
    folder_.Write(file, Replace(ReadText(folder_.path() / file), from, to));
  }

  std::string Text(bool has_tyre = true) {
    std::vector<fs::path> tyres;
    if (has_tyre) tyres.push_back(folder_.path() / "car/tyre.json");
    return ChronoVehicleText(folder_.path() / "vehicle.json", tyres, "car", "car.urdf", found_);
  }

  Vehicle Read(const std::string& text) {
    Diagnostics faults;
    std::optional<Vehicle> vehicle = ReadVehicleText(text, "car.urdf", faults);
    EXPECT_TRUE(vehicle) << faults.Format();
    EXPECT_TRUE(faults.items().empty()) << faults.Format();
    return vehicle.value_or(Vehicle());
  }

  int Line(const std::string& file, const std::string& part) {
    const std::string text = ReadText(folder_.path() / file);
    return 1 + static_cast<int>(
                   std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(part)), '\n'));
  }

  TemporaryFolder folder_;
  Diagnostics found_;
};

double Hertz(double rate, double mass) { return std::sqrt(rate / mass) / (2 * std::numbers::pi); }
double InSeries(double a, double b) { return a * b / (a + b); }

// By hand. A wishbone's end moves 0.35 m from its axis and the coil 0.2 m, so that the wheel has (0.2 / 0.35)^2 of the
// coil's 100 N/mm. Half of each arm of 3 and 5 kg counts with the chassis, a quarter of whose 1200 kg each wheel
// carries.
TEST_F(ChronoText, GivesTheNumbersThatFollowByHand) {
  const std::string text = Text();
  // The guide of its beam axle is named, nothing else.
  EXPECT_THAT(found_, ReportsOnly(kChronoGuide, Line("car/leaf.json", "Template"))) << found_.Format();
  const Vehicle vehicle = Read(text);
  const VehicleSummary summary = Summarise(vehicle, vehicle.ParameterValues());
  ASSERT_EQ(summary.chassis.axles.size(), 2U);
  const AxleNumbers& front = summary.chassis.axles[0];
  const AxleNumbers& rear = summary.chassis.axles[1];
  // Free lengths are rounded to a hundredth of a micrometre, tyres' radii to a nanometre.
  const double wheel_rate = 100e3 * std::pow(0.2 / 0.35, 2);
  EXPECT_NEAR(*front.sprung_kg, 2 * 304, 1e-3);
  EXPECT_NEAR(*front.unsprung_kg, 2 * (10 + 20 + 12 + 4), 1e-3);
  EXPECT_NEAR(*rear.sprung_kg, 2 * 300, 1e-3);
  EXPECT_NEAR(*rear.unsprung_kg, 80 + 2 * (10 + 20), 1e-3);
  EXPECT_NEAR(*front.ride_Hz, Hertz(InSeries(wheel_rate, 200e3), 304), 1e-4);
  EXPECT_NEAR(*front.hop_Hz, Hertz(wheel_rate + 200e3, 46), 1e-3);
  EXPECT_NEAR(*rear.ride_Hz, Hertz(InSeries(30e3, 200e3), 300), 1e-4);
  EXPECT_NEAR(front.load_N, kGravity * (2 * 304 + 92), 0.1);
  EXPECT_NEAR(rear.load_N, kGravity * (2 * 300 + 140), 0.1);
  // Tyres stand at their loaded radii.
  for (const Tyre& tyre : vehicle.tyres) {
    const double load = 0.5 * (tyre.name.starts_with("front") ? front.load_N : rear.load_N);
    EXPECT_NEAR(tyre.radius, 0.32 - load / 200e3, 2e-6) << tyre.name;
    EXPECT_EQ(tyre.damping.value, 150);
  }
}

TEST_F(ChronoText, TakesLawsAsTheyAre) {
  const Vehicle vehicle = Read(Text());
  const std::vector<double> values = vehicle.ParameterValues();
  for (const Damper& damper : vehicle.dampers) {
    const DashpotLaw law = damper.law.At(values);
    if (damper.name.starts_with("front")) {
      EXPECT_DOUBLE_EQ(law.Force(0.5), 6000 * 0.5 / (1 + 2 * 0.5));
      EXPECT_DOUBLE_EQ(law.Force(-0.5), -6000 * 0.5 / (1 + 4 * 0.5));
    } else {
      // Points of a cubic, in rounding.
      EXPECT_NEAR(law.Force(0.1), 600, 1e-9);
      EXPECT_NEAR(law.Force(-1), -1000, 1e-9);
    }
  }
  for (const Spring& spring : vehicle.springs) {
    if (spring.kind != Spring::Kind::kStop || !spring.name.starts_with("front")) continue;
    const SpringLaw law = spring.law.At(values);
    // From 400 mm at rest, stops at 300 and 460 mm; to the micrometre of a pose at rest.
    EXPECT_NEAR(law.Force(-0.11), -(100e3 * 0.01 + 0.06e9 * 1e-6), 0.2);
    EXPECT_NEAR(law.Force(0.08), 100e3 * 0.02 + 0.06e9 * 8e-6, 0.2);
    EXPECT_EQ(law.Force(0.05), 0);
  }
}

// With other free lengths the car stands elsewhere: its springs, left to equilibrium in the file, carry what Chrono's
// laws give at the lengths in which they are drawn.
TEST_F(ChronoText, StandsWhereItsFreeLengthsLetIt) {
  Change("car/wishbones.json", "0.45217138", "0.44");
  Change("car/leaf.json", "0.4480665", "0.47");
  const Vehicle vehicle = Read(Text());
  const std::optional<SettledPose> pose = Settle(vehicle, vehicle.ParameterValues());
  ASSERT_TRUE(pose);
  // What equilibrium holds is at rest as written.
  EXPECT_LT(pose->Shift(), 1e-6);
  int seen = 0;
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i) {
    const Spring& spring = vehicle.springs[i];
    if (spring.kind != Spring::Kind::kCoil) continue;
    const bool is_front = spring.name.starts_with("front");
    const double length = pose->springs[i].length;
    const double push = is_front ? 100e3 * (0.44 - length) : 30e3 * (0.47 - length);
    // The tyres' feet lie straight below the wheels in the chassis's frame, which pitches by half a degree.
    EXPECT_NEAR(-pose->springs[i].force, push, 2) << spring.name;
    EXPECT_GT(std::abs(length - (is_front ? 0.4 : 0.35)), 5e-3) << "it has moved";
    ++seen;
  }
  EXPECT_EQ(seen, 4);
}

/// Double wishbones as a MacPherson strut, whose coil covers seven tenths of the strut's length, from a tenth below
/// its top.
const std::string kStrut = R"({
  "Name": "strut", "Type": "Suspension", "Template": "MacPhersonStrut",
  "Spindle": { "Mass": 10, "COM": [0, 0.75, 0], "Inertia": [0.05, 0.08, 0.05], "Radius": 0.1, "Width": 0.06 },
  "Upright": {
    "Mass": 12, "COM": [0, 0.7, 0], "Moments of Inertia": [0.1, 0.1, 0.05], "Products of Inertia": [0, 0, 0],
    "Radius": 0.02
  },
  "Strut": { "Mass": 2, "Inertia": [0.01, 0.01, 0.01], "Radius": 0.02 },
  "Control Arm": {
    "Mass": 5, "COM": [0, 0.525, -0.15], "Moments of Inertia": [0.05, 0.02, 0.06], "Products of Inertia": [0, 0, 0],
    "Radius": 0.02,
    "Location Chassis Front": [0.15, 0.35, -0.15], "Location Chassis Back": [-0.15, 0.35, -0.15],
    "Location Upright": [0, 0.7, -0.15]
  },
  "Tierod": { "Location Chassis": [0.12, 0.35, -0.1], "Location Upright": [0.12, 0.7, -0.1] },
  "Spring": {
    "Location Chassis": [0, 0.56, 0.5], "Location Upright": [0, 0.63, 0.15],
    "Spring Coefficient": 50000, "Free Length": 0.42, "Minimum Length": 0.29, "Maximum Length": 0.43
  },
  "Shock": {
    "Location Chassis": [0, 0.55, 0.55], "Location Upright": [0, 0.65, 0.05], "Damping Coefficient": 3000
  },
  "Axle": { "Inertia": 0.4 }
})";

// Its spring is written along the strut, but free length and stops count between the coil's own ends, which stay three
// tenths of the strut as drawn from those of the strut.
TEST_F(ChronoText, TakesTheCoilOfAStrutBetweenItsOwnEnds) {
  folder_.Write("car/strut.json", kStrut);
  Change("vehicle.json", "car/wishbones.json", "car/strut.json");
  const Vehicle vehicle = Read(Text());
  EXPECT_THAT(found_, Reports(kChronoStrutApart));
  const std::vector<double> values = vehicle.ParameterValues();
  const std::optional<SettledPose> pose = Settle(vehicle, values);
  ASSERT_TRUE(pose);
  EXPECT_LT(pose->Shift(), 1e-6);
  const double rest = 0.3 * std::hypot(0.1, 0.5);
  double coil = 0;
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i) {
    if (vehicle.springs[i].name != "front_coil_left") continue;
    coil = pose->springs[i].length - rest;
    // As in StandsWhereItsFreeLengthsLetIt.
    EXPECT_NEAR(-pose->springs[i].force, 50e3 * (0.42 - coil), 2);
  }
  ASSERT_GT(coil, 0.29);
  ASSERT_LT(coil, 0.43);
  int stops = 0;
  for (const Spring& spring : vehicle.springs) {
    if (spring.kind != Spring::Kind::kStop || !spring.name.starts_with("front")) continue;
    const SpringLaw law = spring.law.At(values);
    // To the micrometre of a pose at rest.
    EXPECT_NEAR(law.Force(0.29 - coil - 0.01), -(100e3 * 0.01 + 0.06e9 * 1e-6), 0.5);
    EXPECT_NEAR(law.Force(0.43 - coil + 0.01), 100e3 * 0.01 + 0.06e9 * 1e-6, 0.5);
    ++stops;
  }
  EXPECT_EQ(stops, 2);
}

// Before they come to rest the springs would be shorter than their stops let them.
TEST_F(ChronoText, WarnsOfThePoseThatItWrites) {
  Change("car/wishbones.json", "0.45217138", "0.52");
  Change("car/wishbones.json", "\"Minimum Length\": 0.3, \"Maximum Length\": 0.46",
         "\"Minimum Length\": 0.41, \"Maximum Length\": 0.6");
  EXPECT_FALSE(Text().empty());
  EXPECT_THAT(found_, ReportsOnly(kChronoGuide, Line("car/leaf.json", "Template")));
}

TEST_F(ChronoText, TakesHolesFromTheWholeInAnyOrder) {
  const std::string hole = R"({
      "Centroidal Frame": { "Location": [0.5, 0, 0.25], "Orientation": [1, 0, 0, 0] },
      "Mass": 300, "Moments of Inertia": [10, 20, 30], "Products of Inertia": [0, 0, 0], "Void": true
    })";
  const auto body = [&] {
    const auto car = ReadChronoVehicle(folder_.path() / "vehicle.json", {folder_.path() / "car/tyre.json"}, {}, found_);
    return car ? car->car.body.value() : KnownBody();
  };
  const std::string chassis = ReadText(folder_.path() / "car/chassis.json");
  for (const std::string& text : {Replace(chassis, "[\n    {", "[\n    " + hole + ",\n    {"),
                                  Replace(chassis, "}\n  ]", "},\n    " + hole + "\n  ]")}) {
    folder_.Write("car/chassis.json", text);
    const KnownBody left = body();
    EXPECT_DOUBLE_EQ(left.mass, 900) << found_.Format();
    EXPECT_NEAR(left.com.x(), -300 * 0.5 / 900, 1e-12);
    EXPECT_NEAR(left.com.z(), 0.25, 1e-12);
    // About its centre: 1600 + 1200 r^2 - (20 + 300 s^2), r and s the distances of both parts from there.
    EXPECT_NEAR(left.inertia(1, 1), 1600 + 1200 * std::pow(0.5 / 3, 2) - 20 - 300 * std::pow(2.0 / 3, 2), 1e-9);
    EXPECT_NEAR(left.inertia(0, 0), 450 - 10, 1e-9);
  }
}

TEST_F(ChronoText, GuessesTyresWithAWarning) {
  const std::string text = Text(false);
  EXPECT_FALSE(text.empty());
  EXPECT_THAT(found_, Reports(kChronoNoTyre));
  Read(text);
}

TEST_F(ChronoText, TakesTheRateOfALoadIndex) {
  Change("car/tyre.json", "\"Vertical Stiffness\": 200000", "\"Rim Radius\": 0.2, \"Load Index\": 91");
  const Vehicle vehicle = Read(Text());
  // 91 stands for 615 kg; the formula is within 2 % of the table.
  EXPECT_NEAR(vehicle.tyres[0].law.stiffness.At(vehicle.ParameterValues()), 615 * 9.81 / (0.16 * 0.12), 0.02 * 315e3);
}

TEST_F(ChronoText, ReportsAllFaultsOfAllFiles) {
  Change("vehicle.json", "car/leaf.json", "car/lief.json");
  Change("car/wishbones.json", "\"Mass\": 12", "\"Mass\": \"heavy\"");
  Change("car/wishbones.json", "\"Free Length\": 0.45217138, ", "");
  Change("car/chassis.json", "[0, 0, 0.25]", "[0, 0.25]");
  EXPECT_TRUE(Text().empty());
  EXPECT_THAT(found_, Reports(kChronoFileMissing, Line("vehicle.json", "car/lief.json"), {"car/lief.json"}));
  EXPECT_THAT(found_, Reports(kChronoValue, Line("car/wishbones.json", "heavy"), {"Upright/Mass"}));
  EXPECT_THAT(found_, Reports(kChronoMissing, Line("car/wishbones.json", "\"Spring\""), {"Free Length"}));
  EXPECT_THAT(found_, Reports(kChronoValue, Line("car/chassis.json", "\"Location\""), {"Location"}));
}

TEST_F(ChronoText, RefusesWhatItDoesNotRead) {
  Change("car/leaf.json", "LeafspringAxle", "HendricksonPRIMAXX");
  EXPECT_TRUE(Text().empty());
  EXPECT_THAT(found_, ReportsOnly(kChronoTemplate, Line("car/leaf.json", "Hendrickson"),
                                  {"HendricksonPRIMAXX", "DoubleWishbone"}));
}

TEST_F(ChronoText, RefusesEmptyTexts) {
  Change("car/leaf.json", "\"LeafspringAxle\"", "\"\"");
  EXPECT_TRUE(Text().empty());
  EXPECT_THAT(found_, ReportsOnly(kChronoValue, Line("car/leaf.json", "Template"), {"Template", "a name"}));
}

TEST_F(ChronoText, RefusesTyresOfNoSize) {
  Change("car/tyre.json", "\"Unloaded Radius\": 0.32", "\"Unloaded Radius\": 320");
  EXPECT_TRUE(Text().empty());
  EXPECT_THAT(found_, Reports(kChronoRange, Line("car/tyre.json", "Unloaded"), {"Unloaded Radius", "320 m", "1.5 m"}));
  EXPECT_THAT(found_, testing::Not(Reports(kChronoMissing)));
  found_ = {};
  Change("car/tyre.json", "\"Unloaded Radius\": 320, ", "");
  EXPECT_TRUE(Text().empty());
  EXPECT_THAT(found_, Reports(kChronoMissing, {"Unloaded Radius"}));
}

std::string Times(int count, const std::string& item) {
  std::string text;
  for (int i = 0; i < count; ++i) text += (i > 0 ? "," : "") + item;
  return text;
}

TEST_F(ChronoText, RefusesLongLists) {
  folder_.Write("car/chassis.json", "{\"Components\": [" + Times(1001, "{}") + "]}");
  Change("car/wishbones.json", "[0.05, 0.08, 0.05]", "[0.05, 0.08, 0.05], \"Ignored\": [" + Times(1001, "0") + "]");
  Change("car/leaf.json", "[-1, -1000], ", Times(1001, "[0, 0]") + ",");
  Change("vehicle.json", "\"Axles\": [", "\"Steering Subsystems\": [" + Times(11, "{}") + "],\n\"Axles\": [");
  EXPECT_TRUE(Text().empty());
  EXPECT_THAT(found_, Reports(kChronoTooMany, 1, {"Components", "1001", "1000"}));
  EXPECT_THAT(found_, Reports(kChronoTooMany, Line("car/leaf.json", "Damping Curve Data"), {"1005", "1000"}));
  EXPECT_THAT(found_, Reports(kChronoTooMany, Line("vehicle.json", "Steering Sub"), {"11", "10"}));
  // And the guide of its beam axle.
  EXPECT_EQ(found_.items().size(), 4U) << found_.Format();
}

TEST_F(ChronoText, RefusesLargeFiles) {
  folder_.Write("car/chassis.json", ReadText(folder_.path() / "car/chassis.json") + std::string(1 << 20, ' '));
  EXPECT_TRUE(Text().empty());
  EXPECT_THAT(found_, Reports(kChronoTooLarge, 0, {"1 MiB"}));
}

TEST_F(ChronoText, RefusesBrokenJson) {
  Change("vehicle.json", "\"Axles\": [", "\"Axles\": ");
  EXPECT_TRUE(Text().empty());
  EXPECT_THAT(found_, Reports(kChronoNoJson));
}

TEST_F(ChronoText, RefusesAnotherNumberOfAxles) {
  const std::string text = ReadText(folder_.path() / "vehicle.json");
  const std::size_t second = text.find("    {\n      \"Suspension Input File\": \"car/leaf");
  folder_.Write("vehicle.json", text.substr(0, text.rfind("},", second) + 1) + "]}");
  EXPECT_TRUE(Text().empty());
  EXPECT_THAT(found_, Reports(kChronoAxles, {"1 axles"}));
}

TEST_F(ChronoText, WritesRatesOfAShockThatDoesNotLevelOff) {
  Change("car/wishbones.json", "\"Degressivity Compression\": 4, \"Degressivity Expansion\": 2",
         "\"Degressivity Compression\": 0, \"Degressivity Expansion\": 0");
  const Vehicle vehicle = Read(Text());
  EXPECT_EQ(LintDescription(vehicle).Format(), "");
  EXPECT_EQ(vehicle.dampers[0].law.kind, DashpotDescription::Kind::kBilinear);
  EXPECT_DOUBLE_EQ(vehicle.dampers[0].law.At(vehicle.ParameterValues()).Force(0.5), 6000 * 0.5);
}

TEST_F(ChronoText, WritesACurveOfAShockThatLevelsOffOneWay) {
  Change("car/wishbones.json", "\"Degressivity Compression\": 4", "\"Degressivity Compression\": 0");
  const Vehicle vehicle = Read(Text());
  EXPECT_EQ(LintDescription(vehicle).Format(), "");
  const DashpotLaw law = vehicle.dampers[0].law.At(vehicle.ParameterValues());
  // Points of the curve.
  EXPECT_NEAR(law.Force(-0.5), -6000 * 0.5, 1e-6);
  EXPECT_NEAR(law.Force(0.5), 6000 * 0.5 / (1 + 2 * 0.5), 1e-6);
  // Of a cubic between them.
  EXPECT_NEAR(law.Force(0.7) / (6000 * 0.7 / (1 + 2 * 0.7)), 1, 0.02);
}

TEST_F(ChronoText, RefusesWhatNoTyreOrShockHas) {
  Change("car/wishbones.json", "\"Degressivity Expansion\": 2", "\"Degressivity Expansion\": -2");
  Change("car/tyre.json", "\"Vertical Stiffness\": 200000", "\"Vertical Stiffness\": 0");
  EXPECT_TRUE(Text().empty());
  EXPECT_THAT(found_, Reports(kChronoValue, Line("car/wishbones.json", "Degressivity"),
                              {"Degressivity Expansion", "zero or above"}));
  EXPECT_THAT(found_, Reports(kChronoValue, Line("car/tyre.json", "Vertical"), {"Vertical Stiffness", "above zero"}));
  EXPECT_THAT(found_, testing::Not(Reports(kChronoTyreRate)));
}

TEST_F(ChronoText, RefusesExchangedAxles) {
  Change("vehicle.json", "[1.3, 0, 0]", "[-1.3, 0, 0]");
  Change("vehicle.json", "[-1.3, 0, -0.000980665]", "[1.3, 0, -0.000980665]");
  EXPECT_TRUE(Text().empty());
  EXPECT_THAT(found_, Reports(kChronoAxleOrder, Line("vehicle.json", "\"Axles\""), {"-1300 mm", "1300 mm"}));
  EXPECT_THAT(found_.Format(), testing::Not(testing::HasSubstr("header")));
}

TEST_F(ChronoText, RefusesCurvesThatFall) {
  Change("car/leaf.json", "[-0.2, -6000]", "[-0.2, -2000]");
  Change("car/leaf.json", "[0.1, 600]", "[0.1, -600]");
  EXPECT_TRUE(Text().empty());
  EXPECT_THAT(found_, Reports(kChronoValue, Line("car/leaf.json", "Spring Curve Data")));
  EXPECT_THAT(found_, Reports(kChronoValue, Line("car/leaf.json", "Damping Curve Data")));
}

TEST_F(ChronoText, WritesAsDrawnWhatFindsNoRest) {
  // Springs of no length lift the car off its tyres.
  Change("car/wishbones.json", "0.45217138", "9");
  const std::string text = Text();
  EXPECT_THAT(found_, Reports(kChronoNotSettled));
  Read(text);
}

}  // namespace
}  // namespace fourpost::chrono_text_test
