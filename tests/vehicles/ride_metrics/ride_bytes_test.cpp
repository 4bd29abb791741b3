#include "vehicles/ride_metrics/ride_bytes.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/ride_metrics/road_ride.h"

namespace fourpost::ride_bytes_test {
namespace {

/// All numbers of a ride, by name.
std::vector<NamedMetric> NumbersOf(const RideInstruments& instruments, const Vehicle& vehicle) {
  const std::vector<double> values = vehicle.ParameterValues();
  return NamedMetrics(
      RideOnRoad(instruments, CondensedVehicle(vehicle).At(values), values, {.roughness_m3 = 256e-6, .speed = 60 / 3.6})
          .metrics);
}

TEST(RideBytes, KeepAllThatARideNeeds) {
  for (const char* name : {"quarter_car", "landrover110", "independent_roadster"}) {
    const RideInstruments instruments = InstrumentRide(ShippedVehicle(name));
    const RideInstruments read = RideInstrumentsOf(BytesOf(instruments));
    const std::vector<NamedMetric> expected = NumbersOf(instruments, instruments.vehicle);
    const std::vector<NamedMetric> numbers = NumbersOf(read, instruments.vehicle);
    ASSERT_EQ(numbers.size(), expected.size()) << name;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(numbers[i].name, expected[i].name);
      EXPECT_EQ(std::isnan(numbers[i].value), std::isnan(expected[i].value)) << expected[i].name;
      if (std::isnan(expected[i].value)) continue;
      EXPECT_EQ(numbers[i].value, expected[i].value) << expected[i].name;
    }
  }
}

TEST(RideBytes, RefuseOthers) {
  const std::string bytes = BytesOf(InstrumentRide(ShippedVehicle("quarter_car")));
  EXPECT_THROW(RideInstrumentsOf(bytes.substr(1)), std::invalid_argument);
  EXPECT_THROW(RideInstrumentsOf(bytes + " "), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::ride_bytes_test
