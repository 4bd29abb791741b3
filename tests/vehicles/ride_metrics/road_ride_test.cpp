#include "vehicles/ride_metrics/road_ride.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/linear_response.h"

namespace fourpost::road_ride_test {
namespace {

constexpr RoadRequest kRoadC{.roughness_m3 = 256e-6, .speed = 60 / 3.6};

RoadRide RideOf(const Vehicle& vehicle, const RoadRequest& request) {
  const RideInstruments instruments = InstrumentRide(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  return RideOnRoad(instruments, CondensedVehicle(instruments.vehicle).At(values), values, request);
}

TEST(RoadRide, RefinesItsGrid) {
  for (const char* name : {"landrover110_linkage", "landrover110", "independent_roadster"}) {
    const RoadRide ride = RideOf(ShippedVehicle(name), kRoadC);
    EXPECT_TRUE(ride.converged) << name;
    EXPECT_LE(ride.grid_change, 1e-3) << name;
  }
}

// Of a linear car all rms grow with the root of the roughness.
TEST(RoadRide, IsProportionalToALinearCarsRoad) {
  const Vehicle car = WithLinearTyres(ShippedVehicle("landrover110_linkage"));
  RoadRequest rough = kRoadC;
  rough.roughness_m3 *= 4;
  const RoadRide one = RideOf(car, kRoadC);
  const RoadRide two = RideOf(car, rough);
  EXPECT_NEAR(two.metrics.comfort[0].weighted.rms / one.metrics.comfort[0].weighted.rms, 2, 1e-9);
  EXPECT_NEAR(two.metrics.load_variance / one.metrics.load_variance, 4, 1e-9);
  // Jacking as well: bilinear dampers have no scale.
  EXPECT_NEAR(two.metrics.body->mean_heave / one.metrics.body->mean_heave, 2, 1e-6);
}

// With linear dampers the largest gain in heave is that of the linear response.
TEST(RoadRide, GainsAreThoseOfTheLinearResponse) {
  Vehicle car = WithLinearTyres(ShippedVehicle("landrover110_model1"));
  for (Damper& damper : car.dampers) damper.law.rebound = damper.law.compression;
  const RoadRide ride = RideOf(car, kRoadC);
  const RideInstruments instruments = InstrumentRide(car);
  const CondensedModel model = CondensedVehicle(instruments.vehicle).At(car.ParameterValues());
  const std::vector<BodyGain> gains = BodyGainsOf(instruments, RandomVehicle(model, ride.grid), ride.gains);
  ASSERT_FALSE(gains.empty());
  EXPECT_EQ(gains[0].pattern, "heave");
  const Eigen::MatrixXcd response = LinearResponse(model, gains[0].at_Hz);
  const auto centre = static_cast<Eigen::Index>(instruments.chassis->centre);
  EXPECT_NEAR(gains[0].largest, std::abs(response.row(centre).sum()), 1e-9);
  EXPECT_GT(gains[0].largest, 1);
}

TEST(RoadRide, SpectraIntegrateToTheRms) {
  const RoadRide ride = RideOf(ShippedVehicle("landrover110_linkage"), kRoadC);
  double square = 0;
  const RideSpectra& spectra = ride.spectra;
  for (std::size_t k = 1; k < spectra.frequency_Hz.size(); ++k)
    square += (spectra.frequency_Hz[k] - spectra.frequency_Hz[k - 1]) *
              (spectra.channels[0].density[k] + spectra.channels[0].density[k - 1]) / 2;
  // By the trapezoidal rule on Gauss's points.
  EXPECT_NEAR(std::sqrt(square) / ride.metrics.comfort[0].rms, 1, 0.02);
}

TEST(RoadRide, SharesOfTimeAreWhole) {
  const RoadRide ride = RideOf(ShippedVehicle("independent_roadster"), kRoadC);
  for (const RideMetrics::Strut& strut : ride.metrics.struts) {
    double sum = 0;
    for (const double share : strut.speed_share) sum += share;
    EXPECT_NEAR(sum, 1, 1e-12) << strut.damper;
  }
  // Front springs have a stop on either side.
  EXPECT_GT(ride.metrics.stops.size(), 4u);
}

TEST(RoadRide, RefusesWhatIsNoRoad) {
  const Vehicle car = ShippedVehicle("landrover110_linkage");
  EXPECT_THROW(RideOf(car, {.roughness_m3 = 0, .speed = 20}), std::invalid_argument);
  EXPECT_THROW(RideOf(car, {.roughness_m3 = 1e-5, .speed = 20, .lower_Hz = 5, .upper_Hz = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::road_ride_test
