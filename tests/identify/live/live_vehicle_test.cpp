#include "identify/live/live_vehicle.h"

#include <cmath>
#include <cstring>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "identify/experiments/four_post/modelled_response.h"
#include "identify/live/live_calls.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/reduced_bytes.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost::live_vehicle_test {
namespace {

using testing::HasSubstr;

ReducedData DataOf(const Vehicle& vehicle) { return CondensedVehicle(vehicle).reduced().data(); }

Excitation InHeave(const Vehicle& vehicle) {
  return {.frequency_Hz = {0.7, 1.5, 3, 8, 14},
          .amplitude_m = {0.01, 0.008, 0.005, 0.002, 0.001},
          .shape = std::vector<double>(vehicle.posts.size(), 1)};
}

TEST(LiveVehicle, AnswersAsTheModelOfAFit) {
  for (const char* name : {"quarter_car", "landrover110_linkage", "landrover110_model3"}) {
    const Vehicle vehicle = ShippedVehicle(name);
    const Excitation excitation = InHeave(vehicle);
    LiveVehicle live(DataOf(vehicle));
    std::vector<double> values = vehicle.ParameterValues();
    values[0] *= 1.1;
    live.Set(values);
    const FrequencyResponse response = live.Response(excitation);
    const FrequencyResponse expected =
        ModelledResponse(CondensedVehicle(vehicle).At(values), vehicle.sensors, excitation).response;
    ASSERT_EQ(response.channels.size(), expected.channels.size() + static_cast<std::size_t>(live.data().coordinates));
    for (std::size_t c = 0; c < expected.channels.size(); ++c) {
      EXPECT_EQ(response.channels[c].response, expected.channels[c].response) << name << ' ' << c;
      EXPECT_EQ(response.channels[c].mean, expected.channels[c].mean);
    }
  }
}

TEST(LiveVehicle, HasTheModesOfItsModel) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const LiveVehicle live(DataOf(vehicle));
  const std::vector<Mode> expected = ModesOf(CondensedVehicle(vehicle).At(vehicle.ParameterValues()));
  const std::vector<Mode> modes = live.Modes();
  ASSERT_EQ(modes.size(), expected.size());
  for (std::size_t i = 0; i < modes.size(); ++i) EXPECT_EQ(modes[i].frequency_Hz, expected[i].frequency_Hz);
}

TEST(LiveVehicle, HasNoResponsesWithHysteresis) {
  Diagnostics diagnostics;
  const Vehicle vehicle =
      ReadVehicle(std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies/single_wheel_station/model4.urdf", diagnostics)
          .value();
  const LiveVehicle live(DataOf(vehicle));
  EXPECT_TRUE(live.IsHysteretic());
  for (const ChannelResponse& channel : live.Response(InHeave(vehicle)).channels)
    for (const std::complex<double>& value : channel.response) EXPECT_TRUE(std::isnan(value.real()));
  EXPECT_FALSE(live.Modes().empty());
}

/// As a page calls them.
TEST(LiveCalls, SayWhyTheyRefuse) {
  std::memcpy(live_room(8), "<robot/>", 8);
  EXPECT_EQ(live_open(8, 0), -1);
  EXPECT_THAT(live_fault(), HasSubstr("no reduced vehicle"));
  EXPECT_EQ(live_set(0), -1) << "there is no vehicle";

  const Vehicle vehicle = ShippedVehicle("quarter_car");
  const std::string bytes = BytesOf(DataOf(vehicle));
  std::memcpy(live_room(bytes.size()), bytes.data(), bytes.size());
  EXPECT_EQ(live_open(bytes.size(), 0), static_cast<int>(vehicle.parameters.size()));
  live_room(8);
  EXPECT_EQ(live_set(1), -1);
  EXPECT_THAT(live_fault(), HasSubstr("parameters"));
}

}  // namespace
}  // namespace fourpost::live_vehicle_test
