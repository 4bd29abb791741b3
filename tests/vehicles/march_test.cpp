#include "vehicles/march.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed_vehicle.h"
#include "vehicles/harmonic_balance.h"

namespace fourpost {
namespace {

using testing::HasSubstr;

std::string Complaint(const MarchOptions& options) {
  try {
    options.Validate();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(March, NamesTheOptionThatIsOutOfBounds) {
  EXPECT_EQ(Complaint({}), "");
  EXPECT_THAT(Complaint({.accuracy = 0}), HasSubstr("accuracy = 0"));
  EXPECT_THAT(Complaint({.tolerance = std::numeric_limits<double>::quiet_NaN()}), HasSubstr("tolerance = "));
  EXPECT_THAT(Complaint({.window_s = -1}), HasSubstr("window_s = -1"));
  EXPECT_THAT(Complaint({.longest_s = 0.1}), HasSubstr("longest_s = 0.1"));
  EXPECT_THAT(Complaint({.samples_per_cycle = 4}), HasSubstr("samples_per_cycle = 4"));
}

// The results themselves are tested against closed forms in quarter_car_test.cpp and harmonic_balance_test.cpp.
TEST(March, TellsWhereTheMotionIsNotYetPeriodic) {
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  const std::vector<double> values = vehicle.ParameterValues();
  Multibody multibody(vehicle);
  multibody.SetParameters(values, CondensedVehicle(vehicle).PreloadsAt(values));
  const MarchedResponse marched = March(multibody, {{8}, {0.001}, {1}}, {.tolerance = 1e-12, .longest_s = 1.2});
  EXPECT_THAT(marched.unsteady_Hz, testing::ElementsAre(8));
  EXPECT_THAT(marched.simulated_s, testing::AllOf(testing::Ge(1.2), testing::Le(1.8)));
}

// At 15 Hz a wheel's first harmonic repeats long before damper jacking has let the body down.
TEST(March, WaitsForTheMeans) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Set(vehicle, "c_bump", 800);
  Set(vehicle, "c_rebound", 2600);
  std::erase_if(vehicle.sensors, [](const Sensor& sensor) { return sensor.name != "s_strut"; });
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  Multibody multibody(vehicle);
  multibody.SetParameters(vehicle.ParameterValues(), model.preloads);
  const Excitation excitation{{15}, {0.001}, {1}};
  const MarchOptions options{.tolerance = 1e-4, .window_s = 0.1};
  const FrequencyResponse marched = March(multibody, excitation, options).response;
  const FrequencyResponse balanced =
      SolveHarmonicBalance(model, vehicle.sensors, excitation, {.harmonics = 31, .samples = 256}).response;
  const ChannelResponse& strut = balanced.channels[0];
  const double size = std::max(std::abs(strut.mean[0]), std::abs(strut.response[0]) * excitation.amplitude_m[0]);
  // The body decays with 0.45 x 2 pi 1.36 Hz = 3.8 1/s: what remains is 1.5 times the change over a window of 0.13 s.
  EXPECT_NEAR(marched.channels[0].mean[0], strut.mean[0], 2 * options.tolerance * size);
}

TEST(March, ReportsEachFrequency) {
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  const std::vector<double> values = vehicle.ParameterValues();
  Multibody multibody(vehicle);
  multibody.SetParameters(values, CondensedVehicle(vehicle).PreloadsAt(values));
  std::vector<std::size_t> heard;
  March(multibody, {{8, 12}, {0.001, 0.001}, {1}}, {}, [&](std::size_t done) { heard.push_back(done); });
  EXPECT_THAT(heard, testing::ElementsAre(1, 2));
}

}  // namespace
}  // namespace fourpost
