#include "vehicles/ride_metrics/ride_instruments.h"

#include <gtest/gtest.h>

#include "tests/vehicles/shipped_vehicle.h"

namespace fourpost::ride_instruments_test {
namespace {

TEST(RideInstruments, ReadTheChassisAndAllElements) {
  const Vehicle car = ShippedVehicle("independent_roadster");
  const RideInstruments instruments = InstrumentRide(car);
  EXPECT_EQ(instruments.points.size(), 4u);
  EXPECT_EQ(instruments.points[0].weighting, Weighting::kWk);
  EXPECT_EQ(instruments.loads.size(), car.tyres.size());
  EXPECT_EQ(instruments.dampers.size(), car.dampers.size());
  ASSERT_EQ(instruments.axles.size(), 2u);
  EXPECT_EQ(instruments.axles[0].name, "front");
  EXPECT_EQ(instruments.axles[0].posts.size(), 2u);
  ASSERT_TRUE(instruments.chassis);
  for (const std::size_t sensor : instruments.loads)
    EXPECT_EQ(instruments.vehicle.sensors[sensor].type, Sensor::Type::kLoadCell);
  for (std::size_t i = 0; i < car.sensors.size(); ++i)
    EXPECT_EQ(instruments.vehicle.sensors[i].name, car.sensors[i].name);
}

// The chassis moves up by one everywhere in heave, and by its lever in pitch and roll.
TEST(RideInstruments, ChassisHeightsAreItsMotion) {
  const RideInstruments instruments = InstrumentRide(ShippedVehicle("landrover110_model3"));
  const CondensedVehicle condensed(instruments.vehicle);
  const CondensedModel model = condensed.At(instruments.vehicle.ParameterValues());
  const auto row = [&](std::size_t sensor) { return model.on_position.row(static_cast<Eigen::Index>(sensor)).eval(); };
  // The joints of its body are a heave, a roll and a pitch about the centre of mass.
  const Eigen::RowVectorXd heave = row(instruments.chassis->centre);
  const Eigen::RowVectorXd pitch = heave - row(instruments.chassis->ahead);
  const Eigen::RowVectorXd roll = row(instruments.chassis->left) - heave;
  EXPECT_NEAR(heave[0], 1, 1e-9);
  EXPECT_NEAR(pitch.norm(), 1, 1e-9);
  EXPECT_NEAR(roll.norm(), 1, 1e-9);
  EXPECT_NEAR(pitch.dot(roll), 0, 1e-9);
  EXPECT_NEAR(pitch[0], 0, 1e-9);
  EXPECT_NEAR(roll[0], 0, 1e-9);
}

TEST(RideInstruments, WithoutAccelerometersFeelTheCentreOfMass) {
  Vehicle car = ShippedVehicle("landrover110_linkage");
  car.sensors.clear();
  const RideInstruments instruments = InstrumentRide(car);
  ASSERT_EQ(instruments.points.size(), 1u);
  EXPECT_EQ(instruments.points[0].name, "chassis");
  const RidePoint seat{.name = "seat", .point = {LinkOf(car, "chassis"), {0.2, 0.3, 0.4}}, .weighting = Weighting::kWb};
  const RideInstruments with_seat = InstrumentRide(car, {seat});
  ASSERT_EQ(with_seat.points.size(), 1u);
  EXPECT_EQ(with_seat.points[0].name, "seat");
  EXPECT_EQ(with_seat.points[0].weighting, Weighting::kWb);
}

}  // namespace
}  // namespace fourpost::ride_instruments_test
