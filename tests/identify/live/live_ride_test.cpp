#include "identify/live/live_ride.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/ride_metrics/ride_bytes.h"

namespace fourpost::live_ride_test {
namespace {

constexpr RoadRequest kRoad{.roughness_m3 = 256e-6, .speed = 60 / 3.6};

LiveRide LiveRideOf(const RideInstruments& instruments) {
  return {CondensedVehicle(instruments.vehicle).reduced().data(), RideInstrumentsOf(BytesOf(instruments))};
}

TEST(LiveRide, IsThatOfTheCommand) {
  const RideInstruments instruments = InstrumentRide(ShippedVehicle("landrover110_model3"));
  std::vector<double> values = instruments.vehicle.ParameterValues();
  values[0] *= 1.1;
  const RoadRide expected = RideOnRoad(instruments, CondensedVehicle(instruments.vehicle).At(values), values, kRoad);
  const RoadRide ride = LiveRideOf(instruments).Over(values, kRoad);
  ASSERT_EQ(ride.metrics.wheels.size(), 4u);
  EXPECT_EQ(ride.metrics.comfort[0].weighted.rms, expected.metrics.comfort[0].weighted.rms);
  EXPECT_EQ(ride.metrics.wheels[3].rms_N, expected.metrics.wheels[3].rms_N);
  EXPECT_EQ(ride.metrics.struts[0].travel_rms_m, expected.metrics.struts[0].travel_rms_m);
}

TEST(LiveRide, RefusesInstrumentsOfAnotherVehicle) {
  const ReducedData data = CondensedVehicle(InstrumentRide(ShippedVehicle("quarter_car")).vehicle).reduced().data();
  EXPECT_THROW(LiveRide(data, InstrumentRide(ShippedVehicle("landrover110"))), std::invalid_argument);
  // A damaged page.
  RideInstruments damaged = InstrumentRide(ShippedVehicle("quarter_car"));
  EXPECT_NO_THROW(LiveRide(data, damaged));
  damaged.loads[0] = data.sensors.size();
  EXPECT_THROW(LiveRide(data, damaged), std::invalid_argument);
}

TEST(LiveRide, RefusesValuesThatAreNoNumbers) {
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  std::vector<double> values = vehicle.ParameterValues();
  values[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(LiveRideOf(InstrumentRide(vehicle)).Over(values, kRoad), std::runtime_error);
}

// A spring that pushes the body away.
TEST(LiveRide, RefusesAnUnstableVehicle) {
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  const LiveRide live = LiveRideOf(InstrumentRide(vehicle));
  std::vector<double> values = vehicle.ParameterValues();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (vehicle.parameters[i].name == "k") values[i] *= -1;
  EXPECT_THROW(live.Over(values, kRoad), std::runtime_error);
}

}  // namespace
}  // namespace fourpost::live_ride_test
