#include "identify/report/measured_motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost::measured_motion_test {
namespace {

/// A quarter car whose damper has one rate, so that it is linear, on a post at some frequencies.
struct LinearCar {
  explicit LinearCar(double softer) {
    Set(vehicle, "c_rebound", ValueOf(vehicle, "c_bump"));
    Set(vehicle, "k", softer * ValueOf(vehicle, "k"));
    model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  }

  FrequencyResponse Readings() const { return SolveHarmonicBalance(model, vehicle.sensors, excitation, {}).response; }

  /// Frequencies x coordinates.
  Eigen::MatrixXcd Coordinates() const {
    CondensedModel seen = model;
    const Eigen::Index n = model.mass.rows();
    seen.on_position = Eigen::MatrixXd::Identity(n, n);
    seen.on_velocity = seen.on_acceleration = Eigen::MatrixXd::Zero(n, n);
    seen.on_post_height = seen.on_post_velocity = seen.on_post_acceleration = Eigen::MatrixXd::Zero(n, 1);
    for (CondensedModel::Liftoff& liftoff : seen.liftoffs) liftoff.load_cells.clear();
    const std::vector<Sensor> sensors(static_cast<std::size_t>(n), Sensor{.type = Sensor::Type::kDisplacement});
    const FrequencyResponse response = SolveHarmonicBalance(seen, sensors, excitation, {}).response;
    Eigen::MatrixXcd coordinates(static_cast<Eigen::Index>(response.frequency_Hz.size()), n);
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::Index i = 0; i < coordinates.rows(); ++i)
        coordinates(i, j) = response.channels[static_cast<std::size_t>(j)].response[static_cast<std::size_t>(i)];
    return coordinates;
  }

  Excitation excitation{{0.8, 2.0, 12.0}, {0.005, 0.005, 0.001}, {1.0}};
  Vehicle vehicle = ShippedVehicle("quarter_car");
  CondensedModel model;
};

RecordedMotion MotionOf(const LinearCar& model, const LinearCar& measured) {
  RecordedMotion motion{.name = "heave", .excitation = model.excitation, .differences = {}};
  const FrequencyResponse a = model.Readings();
  const FrequencyResponse b = measured.Readings();
  for (std::size_t s = 0; s < a.channels.size(); ++s) {
    motion.differences.push_back({s, {}});
    for (std::size_t i = 0; i < a.frequency_Hz.size(); ++i)
      motion.differences.back().difference.push_back(b.channels[s].response[i] - a.channels[s].response[i]);
  }
  return motion;
}

// A softer car is the measured one: its sensors give its motion, whatever the model's.
TEST(MeasuredMotion, IsThatOfTheCarThatWasMeasured) {
  const LinearCar model(1);
  const LinearCar measured(0.7);
  const Eigen::MatrixXcd found =
      MeasuredMotion(model.vehicle, model.model, MotionOf(model, measured), model.Coordinates());
  const Eigen::MatrixXcd expected = measured.Coordinates();
  ASSERT_EQ(found.rows(), expected.rows());
  EXPECT_GT((model.Coordinates() - expected).norm(), 0.05 * expected.norm());
  // A hundred times what the balance is solved to.
  EXPECT_LT((found - expected).norm(), 1e-4 * expected.norm());
}

TEST(MeasuredMotion, FollowsTheModelWhereNothingIsMeasured) {
  const LinearCar model(1);
  RecordedMotion motion = MotionOf(model, LinearCar(0.7));
  for (ReadingDifference& reading : motion.differences) reading.difference[1] = NAN;
  const Eigen::MatrixXcd found = MeasuredMotion(model.vehicle, model.model, motion, model.Coordinates());
  EXPECT_EQ(found.row(1), model.Coordinates().row(1));
  EXPECT_NE(found.row(0), model.Coordinates().row(0));
  motion.differences.clear();
  EXPECT_EQ(MeasuredMotion(model.vehicle, model.model, motion, model.Coordinates()).rows(), 0);
}

}  // namespace
}  // namespace fourpost::measured_motion_test
