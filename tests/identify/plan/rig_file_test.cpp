// What a rig can measure: what its file says, and every fault with its line.
#include "identify/plan/rig_file.h"

#include <cmath>

#include <gmock/gmock.h>

#include "identify/plan/findings.h"
#include "identify/study_file/findings.h"
#include "tests/findings.h"
#include "tests/vehicles/shipped_vehicle.h"

namespace fourpost::rig_file_test {
namespace {

class RigFileTest : public testing::Test {
 protected:
  RigFileTest() {
    for (std::size_t i = 0; i < vehicle_.parameters.size(); ++i) determined_.push_back(i);
  }
  std::optional<RigFile> Read(const std::string& text) {
    diagnostics_ = {};
    return ReadRigText(text, "rig.yaml", vehicle_, determined_, diagnostics_);
  }

  Vehicle vehicle_ = ShippedVehicle("landrover110_model1");
  std::vector<std::size_t> determined_;
  Diagnostics diagnostics_;
};

TEST_F(RigFileTest, SaysWhatIsThere) {
  const std::optional<RigFile> rig = Read(R"(time: 30 min
cycles: 8
noise: {acceleration: 0.02 m/s^2}
sensors: [a_body_front]
runs:
  - {mode: heave, band: [1 Hz, 4 Hz], frequencies: 3, amplitude: 5 mm}
measurements:
  - {parameter: m_sprung, sd: 1 %, time: 10 min}
want: {k_front: 1 kN/m}
)");
  ASSERT_TRUE(rig.has_value());
  EXPECT_EQ(rig->time_s, 1800);
  ASSERT_EQ(rig->runs.size(), 1U);
  EXPECT_THAT(rig->runs[0].frequency_Hz,
              testing::ElementsAre(1, testing::DoubleNear(2, 1e-12), testing::DoubleNear(4, 1e-12)));
  EXPECT_NEAR(rig->runs[0].amplitude.At(1), 5e-3, 1e-15);
  // Other usual limits hold where nothing else is said: 0.15 m/s, 6 m/s^2.
  EXPECT_NEAR(rig->runs[0].amplitude.At(6), 0.15 / (12 * M_PI), 1e-9);
  EXPECT_NEAR(rig->runs[0].amplitude.At(10), 6 / std::pow(20 * M_PI, 2), 1e-9);
  // Two minutes of set-up, 8 + 2, 4 + 1.5 and 2 + 1.5 s.
  EXPECT_NEAR(rig->TimeOf(rig->runs[0]), 120 + 19, 1e-9);
  EXPECT_NEAR(rig->measurements.at(0).sd, 0.01 * vehicle_.parameters[0].value, 1e-9);
  EXPECT_EQ(rig->wanted.at(0).sd, 1000);
  EXPECT_EQ(std::count(rig->is_read.begin(), rig->is_read.end(), true), 1);
}

TEST_F(RigFileTest, ReportsAllFaultsAtOnce) {
  EXPECT_FALSE(Read(R"(cycle: 8
noise: {acceleration: 0 m/s^2}
sensors: [a_bdy]
runs:
  - {mode: pich, band: [4 Hz, 1 Hz]}
  - {mode: heave}
  - {mode: heave}
measurements:
  - {parameter: m_sprng, sd: 1 %, time: 10 min}
want: {k_front: 1 kg}
)")
                   .has_value());
  EXPECT_THAT(diagnostics_, Reports(kRigSensor, 3, {"a_bdy"}));
  EXPECT_THAT(diagnostics_, Reports(kRigNoiseNone, 2));
  EXPECT_THAT(diagnostics_, Reports(kRigRunMode, 5, {"pich"}));
  EXPECT_THAT(diagnostics_, Reports(kBandOutOfRange, 5));
  EXPECT_THAT(diagnostics_, Reports(kRigRunTwice, 7, {"heave"}));
  EXPECT_THAT(diagnostics_, Reports(kRigMeasurementParameter, 9, {"m_sprng", "m_sprung"}));
  EXPECT_THAT(diagnostics_, Reports(kRigQuantity, 10, {"k_front"}));
}

TEST_F(RigFileTest, ListsAreLists) {
  EXPECT_FALSE(Read("sensors: a_body_front\nmeasurements: {parameter: m_sprung, sd: 1 %, time: 10 min}\n").has_value());
  EXPECT_THAT(diagnostics_, Reports(kRigListNone, 1, {"sensors"}));
  EXPECT_THAT(diagnostics_, Reports(kRigListNone, 2, {"measurements"}));
  EXPECT_FALSE(Read("sensors: []\n").has_value());
}

TEST_F(RigFileTest, NamesAPostOfTheVehicle) {
  EXPECT_FALSE(Read("runs: [{mode: 'XX=1'}]\n").has_value());
  EXPECT_THAT(diagnostics_, ReportsOnly(kRigRunMode, 1, {"XX=1", '`' + vehicle_.posts[0].name + "=1`"}));
}

TEST_F(RigFileTest, TheUsualRigMovesAsThePostsCan) {
  for (const RigRun& run : UsualRig(vehicle_).runs) EXPECT_EQ(run.shape.size(), vehicle_.posts.size());
  const std::vector<RigRun> of_station = UsualRig(ShippedVehicle("quarter_car")).runs;
  ASSERT_FALSE(of_station.empty());
  for (const RigRun& run : of_station) EXPECT_THAT(run.name, testing::StartsWith("heave"));
}

}  // namespace
}  // namespace fourpost::rig_file_test
