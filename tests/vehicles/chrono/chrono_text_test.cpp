#include "vehicles/chrono/chrono_text.h"

#include <cmath>
#include <filesystem>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/findings.h"
#include "tests/temporary_folder.h"
#include "vehicles/chrono/chrono_axle.h"
#include "vehicles/chrono/findings.h"
#include "vehicles/description/gravity.h"
#include "vehicles/poses/settled_pose.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost {
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
  EXPECT_NEAR(vehicle.tyres[0].stiffness.At(vehicle.ParameterValues()), 615 * 9.81 / (0.16 * 0.12), 0.02 * 315e3);
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
}  // namespace fourpost
