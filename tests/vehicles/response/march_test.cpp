#include "vehicles/response/march.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include <gmock/gmock.h>

#include "tests/rounding.h"
#include "tests/vehicles/recorded_rig.h"
#include "tests/vehicles/resting.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost::march_test {
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
  EXPECT_THAT(Complaint({.tolerance = kNan}), HasSubstr("tolerance = "));
  EXPECT_THAT(Complaint({.window_s = -1}), HasSubstr("window_s = -1"));
  EXPECT_THAT(Complaint({.longest_s = 0.1}), HasSubstr("longest_s = 0.1"));
  EXPECT_THAT(Complaint({.samples_per_cycle = 4}), HasSubstr("samples_per_cycle = 4"));
}

/// Posts that move in a pattern.
Excitation Patterned(const Vehicle& vehicle, const std::string& pattern, std::vector<double> frequency_Hz,
                     std::vector<double> amplitude_m) {
  return {std::move(frequency_Hz), std::move(amplitude_m), PostPattern(vehicle, pattern)};
}

void KeepSensors(Vehicle& vehicle, const std::vector<std::string>& names) {
  std::erase_if(vehicle.sensors, [&](const Sensor& sensor) {
    return std::find(names.begin(), names.end(), sensor.name) == names.end();
  });
}

TEST(March, EndsAtItsDeadline) {
  Prepared car(ShippedVehicle("quarter_car"));
  // Some 1e5 s of motion.
  const MarchOptions hanging = {.tolerance = 1e-15, .longest_s = 1e5, .deadline = Deadline::In(0.05)};
  EXPECT_THROW(March(car.multibody, {{8}, {0.001}, {1}}, hanging), TimedOut);
}

// The results themselves are tested against closed forms in quarter_car_test.cpp and harmonic_balance_test.cpp.
TEST(March, TellsWhereTheMotionIsNotYetPeriodic) {
  Prepared car(ShippedVehicle("quarter_car"));
  const MarchedResponse marched = March(car.multibody, {{8}, {0.001}, {1}}, {.tolerance = 1e-12, .longest_s = 1.2});
  ASSERT_EQ(marched.unsteady.size(), 1u);
  const UnsteadyMotion& motion = marched.unsteady[0];
  EXPECT_EQ(motion.frequency_Hz, 8);
  EXPECT_EQ(motion.amplitude_m, 0.001);
  EXPECT_EQ(motion.cycles, 4);
  EXPECT_NE(std::find_if(car.vehicle.sensors.begin(), car.vehicle.sensors.end(),
                         [&](const Sensor& sensor) { return sensor.name == motion.sensor; }),
            car.vehicle.sensors.end());
  EXPECT_GT(motion.change, 1e-12);
  // By then the body, which decays at 3.4 1/s, has lost all but a fiftieth of its transient.
  EXPECT_LT(motion.change, 0.1);
  EXPECT_THAT(marched.simulated_s, testing::AllOf(testing::Ge(1.2), testing::Le(1.8)));
}

// Roll of a car alike on both sides: sensors in the plane of symmetry read only the integrator's noise.
TEST(March, SettlesThoughSensorsAreSilentBySymmetry) {
  Prepared car(ShippedVehicle("landrover110_model3"));
  const std::set<std::string> silent = {"a_cross_member", "a_tow_point", "a_cg"};
  // Small amplitudes, for which the balance's linearised kinematics are good; the wheels' tramp at the second.
  const Excitation excitation = Patterned(car.vehicle, "roll", {4, 12}, {0.00125, 0.00014});
  const MarchedResponse marched = March(car.multibody, excitation);
  ASSERT_THAT(marched.unsteady, testing::IsEmpty());
  const FrequencyResponse balanced = car.Linearised(excitation, {.error = 1e-6}).response;
  for (std::size_t c = 0; c < balanced.channels.size(); ++c)
    for (std::size_t i = 0; i < 2; ++i) {
      const ChannelResponse& channel = marched.response.channels[c];
      if (silent.contains(channel.name)) {
        const double loud = std::abs(marched.response.Find("a_axle_FL")->response[i]);
        EXPECT_LT(std::abs(channel.response[i]), 1e-6 * loud) << channel.name;
      } else {
        // The kinks of bilinear dampers beyond the 31st harmonic.
        EXPECT_LT(std::abs(channel.response[i] / balanced.channels[c].response[i] - 1.0), 5e-5) << channel.name;
      }
    }
}

// Nothing of its kind is loud then; what the posts' motion would make stands in.
TEST(March, SettlesThoughAllSensorsOfAUnitAreSilent) {
  Vehicle vehicle = ShippedVehicle("landrover110_model3");
  vehicle.sensors.push_back({.name = "pitch_rate",
                             .type = Sensor::Type::kGyro,
                             .point = {.link = LinkOf(vehicle, "chassis")},
                             .axis = Eigen::Vector3d::UnitY()});
  KeepSensors(vehicle, {"a_cg", "pitch_rate"});
  Prepared car(vehicle);
  const Excitation excitation = Patterned(vehicle, "roll", {1.5}, {0.01});
  const MarchedResponse marched = March(car.multibody, excitation);
  ASSERT_THAT(marched.unsteady, testing::IsEmpty());
  const double omega = 2 * std::numbers::pi * 1.5;
  EXPECT_LT(std::abs(marched.response.Find("a_cg")->response[0]), 1e-6);
  // Half the diagonal of the tyres.
  const double lever = std::hypot(2.794, 1.486) / 2;
  EXPECT_LT(std::abs(marched.response.Find("pitch_rate")->response[0]), 1e-6 * omega / lever);
}

// A loud sensor does not excuse one that is faint, but not silent: at 30 Hz the body moves by a fiftieth of the axles.
TEST(March, HoldsFaintSensorsToATenthOfTheLoudest) {
  Prepared car(ShippedVehicle("landrover110_model3"));
  const Excitation excitation = Patterned(car.vehicle, "roll", {30}, {3e-4});
  const MarchedResponse marched = March(car.multibody, excitation);
  ASSERT_THAT(marched.unsteady, testing::IsEmpty());
  const FrequencyResponse balanced = car.Linearised(excitation, {.error = 1e-6}).response;
  const std::complex<double> faint = marched.response.Find("a_body_FL")->response[0];
  const double loud = std::abs(marched.response.Find("a_axle_FL")->response[0]);
  ASSERT_LT(std::abs(faint), 0.02 * loud);
  // What remains of the body's transient is less than it changed in the last window of 0.5 s: roll decays
  // at 0.215 x 2 pi 1.19 Hz = 1.6 1/s.
  EXPECT_LT(std::abs(faint - balanced.Find("a_body_FL")->response[0]), 1e-5 * 0.1 * loud);
}

// Dampers of a five-hundredth leave the body swinging for minutes.
TEST(March, NamesTheSensorTheExcitationAndTheModeThatDoesNotSettle) {
  Vehicle vehicle = ShippedVehicle("landrover110_model3");
  for (const char* damper : {"c_front_bump", "c_front_rebound", "c_rear_bump", "c_rear_rebound"})
    Set(vehicle, damper, 5);
  KeepSensors(vehicle, {"a_cg", "s_strut_FL"});
  Prepared car(vehicle);
  const Excitation excitation = Patterned(vehicle, "roll", {2.5}, {0.005});
  const MarchOptions options{.longest_s = 4};
  const MarchedResponse marched = March(car.multibody, excitation, options);
  ASSERT_EQ(marched.unsteady.size(), 1u);
  EXPECT_EQ(marched.unsteady[0].sensor, "s_strut_FL");
  EXPECT_THAT(UnsteadyMessage(vehicle, excitation, marched.unsteady[0], options),
              testing::MatchesRegex("roll at 2.5 Hz, 5 mm.* 4 s.*'s_strut_FL'.*(mean|first harmonic) by [0-9.e-]+ per "
                                    "2 cycles.* 1e-05.*'roll' at [0-9.]+ Hz.* 0.00[0-9]+ .* [0-9]+ s.*"
                                    "\\[unsteady-damping\\]"));
}

TEST(March, SaysSoWhereNoModeIsToBlame) {
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  const UnsteadyMotion motion = {
      .frequency_Hz = 8, .amplitude_m = 0.02, .sensor = "s_strut", .is_mean = true, .change = 0.031, .cycles = 4};
  EXPECT_THAT(UnsteadyMessage(vehicle, {{8}, {0.02}, {0.5}}, motion),
              testing::MatchesRegex("posts 0.5 at 8 Hz, 20 mm.* 60 s.*'s_strut'.*mean by 0.031 per 4 cycles.* 1e-05.*"
                                    "'heave' at [0-9.]+ Hz.* [0-9.]+, .* [0-9]+ s.*\\[unsteady-amplitude\\]"));
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
  const FrequencyResponse balanced = SolveHarmonicBalance(model, vehicle.sensors, excitation, {.error = 1e-6}).response;
  const ChannelResponse& strut = balanced.channels[0];
  const double size = std::max(std::abs(strut.mean[0]), std::abs(strut.response[0]) * excitation.amplitude_m[0]);
  // The body decays with 0.45 x 2 pi 1.36 Hz = 3.8 1/s: what remains is 1.5 times the change over a window of 0.13 s.
  EXPECT_NEAR(marched.channels[0].mean[0], strut.mean[0], 2 * options.tolerance * size);
}

TEST(March, ReportsEachFrequency) {
  Multibody multibody = Resting(ShippedVehicle("quarter_car"));
  std::vector<std::size_t> heard;
  March(multibody, {{8, 12}, {0.001, 0.001}, {1}}, {}, [&](std::size_t done) { heard.push_back(done); });
  EXPECT_THAT(heard, testing::ElementsAre(1, 2));
}

}  // namespace
}  // namespace fourpost::march_test
