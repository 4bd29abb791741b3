// What a plan promises against what a fit of such recordings would state.
#include "identify/plan/plan.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "identify/experiments/four_post/four_post_residuals.h"
#include "identify/experiments/four_post/modelled_response.h"
#include "tests/temporary_folder.h"
#include "tests/vehicles/shipped_vehicle.h"

namespace fourpost::plan_test {
namespace {

constexpr double kNoise_mps2 = 0.02;
constexpr double kNoise_m = 5e-5;
constexpr double kNoise_N = 10;

double NoiseOf(const Sensor& sensor) {
  if (sensor.type == Sensor::Type::kAccelerometer) return kNoise_mps2;
  return sensor.type == Sensor::Type::kLoadCell ? kNoise_N : kNoise_m;
}

/// A recording of the vehicle itself, with the deviations of that noise and the mean offsets of struts.
MeasuredRun RecordingOf(const Vehicle& vehicle, const CondensedModel& model, const RigRun& run) {
  MeasuredRun recording{.name = run.name};
  recording.excitation.shape = run.shape;
  recording.excitation.frequency_Hz = run.frequency_Hz;
  for (const double f : run.frequency_Hz) recording.excitation.amplitude_m.push_back(run.amplitude.At(f));
  const FrequencyResponse response = ModelledResponse(model, vehicle.sensors, recording.excitation).response;
  for (std::size_t s = 0; s < vehicle.sensors.size(); ++s) {
    const ChannelResponse& from = response.channels[s];
    MeasuredChannel channel{.sensor = s, .name = from.name, .unit = from.unit};
    channel.response = from.response;
    for (std::size_t f = 0; f < from.response.size(); ++f) {
      const double w = 2 * M_PI * run.frequency_Hz[f];
      const bool by_acceleration = vehicle.sensors[s].type == Sensor::Type::kAccelerometer;
      const double sd =
          NoiseOf(vehicle.sensors[s]) / (recording.excitation.amplitude_m[f] * (by_acceleration ? w * w : 1));
      channel.radial_sd.push_back(sd);
      channel.tangential_sd.push_back(sd);
    }
    if (vehicle.sensors[s].type == Sensor::Type::kStrut) channel.mean = from.mean;
    recording.channels.push_back(std::move(channel));
  }
  return recording;
}

// The same covariance by the residuals of a study, whose code shares the balance alone. Ranges of parameters weigh less
// than a thousandth of what is measured. The derivatives are the same.
TEST(Plan, PromisesWhatAFitWouldState) {
  const TemporaryFolder folder;
  folder.Write("rig.yaml", R"(time: 10 min
repeats: 1
noise: {acceleration: 0.02 m/s^2, displacement: 0.05 mm, force: 10 N}
model_error: {gain_dB: 0.1, phase: 1 deg, mean: 0.05 mm, floor: 0.02}
runs: [{mode: heave, band: [0.5 Hz, 20 Hz], frequencies: 25, amplitude: 8 mm}]
)");
  const Vehicle vehicle = ShippedVehicle("landrover110_model1");
  const Plan plan = MakePlan({.run = vehicle.file, .rig = folder.path() / "rig.yaml", .threads = 1}, {});
  ASSERT_EQ(plan.runs.size(), 1U);
  ASSERT_EQ(plan.runs[0].repeats, 1);
  const auto car = std::make_shared<const CondensedVehicle>(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  std::vector<std::size_t> free;
  for (const PlannedParameter& one : plan.parameters)
    for (std::size_t i = 0; i < vehicle.parameters.size(); ++i)
      if (vehicle.parameters[i].name == one.name) free.push_back(i);
  ModelError error = plan.rig.model_error;
  // Of a plan noise blurs mean offsets too.
  error.mean_m = std::hypot(kNoise_m, error.mean_m);
  const ResidualBlock block = FourPostResiduals(car, {RecordingOf(vehicle, car->At(values), plan.rig.runs[0])}, error);
  const Eigen::MatrixXd jacobian = block.differentiate(values, free);
  Eigen::MatrixXd information = jacobian.transpose() * jacobian;
  for (std::size_t j = 0; j < free.size(); ++j)
    information(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(j)) += std::pow(plan.parameters[j].before, -2);
  const Eigen::VectorXd stated = information.inverse().diagonal().cwiseSqrt();
  for (std::size_t j = 0; j < free.size(); ++j)
    EXPECT_NEAR(plan.parameters[j].after, stated[static_cast<Eigen::Index>(j)],
                1e-4 * stated[static_cast<Eigen::Index>(j)])
        << plan.parameters[j].name;
}

// In roll its gyro of pitch reads what the balance's iteration leaves; a hundredth of that for noise would make it
// exact.
TEST(Plan, SilentSensorTellsNothing) {
  const TemporaryFolder folder;
  folder.Write("rig.yaml", "sensors: [pitch_rate]\nruns: [{mode: roll, frequencies: 10}]\n");
  const Vehicle vehicle = ShippedVehicle("independent_roadster");
  const Plan plan = MakePlan({.run = vehicle.file, .rig = folder.path() / "rig.yaml"}, {});
  ASSERT_FALSE(plan.parameters.empty());
  for (const PlannedParameter& one : plan.parameters) EXPECT_TRUE(one.IsBeyondReach()) << one.name;
}

// Of a car that is the same on the left and on the right heave moves no roll.
TEST(Plan, NamesWhatNoRunTells) {
  const TemporaryFolder folder;
  folder.Write("rig.yaml", "runs: [{mode: heave, frequencies: 10}]\n");
  const Vehicle vehicle = ShippedVehicle("landrover110_model3");
  const Plan plan = MakePlan({.run = vehicle.file, .rig = folder.path() / "rig.yaml"}, {});
  int beyond = 0;
  for (const PlannedParameter& one : plan.parameters) {
    const bool is_of_roll = one.name == "I_roll" || one.name == "I_front_roll" || one.name == "I_rear_roll";
    const bool is_of_heave = one.name == "m_sprung" || one.name == "c_front_bump";
    EXPECT_FALSE(is_of_roll && !one.IsBeyondReach()) << one.name;
    EXPECT_FALSE(is_of_heave && one.IsBeyondReach()) << one.name;
    beyond += one.IsBeyondReach();
  }
  EXPECT_GE(beyond, 3);
}

}  // namespace
}  // namespace fourpost::plan_test
