#include "vehicles/simulation/condensed_system.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "tests/closed_form/full_car.h"
#include "tests/vehicles/quarter_cars.h"
#include "tests/vehicles/recorded_rig.h"
#include "tests/vehicles/simulation/written_out_cars.h"
#include "vehicles/simulation/multibody_system.h"

namespace fourpost::condensed_system_test {
namespace {

/// Largest difference of the first harmonics, relative to each.
double LargestDifference(const FrequencyResponse& a, const FrequencyResponse& b) {
  double largest = 0;
  for (std::size_t c = 0; c < a.channels.size(); ++c)
    for (std::size_t i = 0; i < a.frequency_Hz.size(); ++i)
      largest = std::max(largest, std::abs(a.channels[c].response[i] / b.channels[c].response[i] - 1.0));
  return largest;
}

/// A march of a closed-form model against its harmonic balance: the first by steps in time, the second by iterating
/// whole cycles.
double MarchAgainstBalance(CondensedModel model, std::vector<double> shape, double stiffest_tyre) {
  RigView rig = ReadAll(model);
  rig.tyre_stiffness = stiffest_tyre;
  const Excitation excitation{{1.1, 4, 12}, {0.01, 0.004, 0.001}, std::move(shape)};
  CondensedSystem system(model, rig, 1e-4);
  const MarchedResponse marched = March(system, excitation, {.samples_per_cycle = 1024});
  EXPECT_TRUE(marched.unsteady.empty());
  const PeriodicResponse balanced = SolveHarmonicBalance(model, rig.sensors, excitation, {.error = 2e-5});
  EXPECT_TRUE(balanced.unconverged_Hz.empty());
  return LargestDifference(marched.response, balanced.response);
}

// The balance's 2e-5, of what a channel could read where it is near a node.
constexpr double kNode = 1e-4;

TEST(CondensedSystem, MarchesTheHalfCarAsItsBalanceHasIt) {
  EXPECT_LT(MarchAgainstBalance(ThesisHalfCar().Model(), {1, -0.7}, 640e3), kNode);
}

FullCar ThesisFullCar() {
  FullCar car{.sprung_mass = 1725,
              .roll_inertia = 700,
              .pitch_inertia = 2600,
              .offset = 0.01,
              .stiffness = {40e3, 41e3, 60e3, 62e3},
              .tyre_stiffness = {300e3, 305e3, 320e3, 322e3}};
  car.front = {.mass = 220,
               .roll_inertia = 60,
               .offset = -0.01,
               .x = 1.456,
               .spring_station = 0.47,
               .damper_station = 0.47,
               .tyre_station = 0.743,
               .damper = {1500, 3500}};
  car.rear = {.mass = 240,
              .roll_inertia = 65,
              .offset = 0.005,
              .x = -1.338,
              .spring_station = 0.5,
              .damper_station = 0.485,
              .tyre_station = 0.743,
              .damper = {2000, 4500}};
  return car;
}

TEST(CondensedSystem, MarchesTheFullCarAsItsBalanceHasIt) {
  EXPECT_LT(MarchAgainstBalance(ThesisFullCar().Model(), {1, 0.6, -0.8, 0.5}, 322e3), kNode);
}

// A mount, whose extension is a coordinate without mass, and a tyre that leaves the ground.
TEST(CondensedSystem, MarchesAVehicleFileAsItsBalanceHasIt) {
  Vehicle vehicle = Describe(SeriesCar());
  vehicle.tyres[0].lifts_off = true;
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const Excitation excitation{{1.3, 12}, {0.02, 0.012}, {1}};
  CondensedSystem system(model, RigViewOf(vehicle), 5e-5);
  const MarchedResponse marched = March(system, excitation, {.samples_per_cycle = 1024});
  ASSERT_TRUE(marched.unsteady.empty());
  const PeriodicResponse balanced = SolveHarmonicBalance(model, vehicle.sensors, excitation, {.error = 2e-5});
  ASSERT_TRUE(balanced.unconverged_Hz.empty());
  EXPECT_LT(LargestDifference(marched.response, balanced.response), kNode);
}

/// On posts that move by a sine of this amplitude.
std::vector<double> HistoryOf(const Vehicle& vehicle, double amplitude_m) {
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  CondensedSystem system(model, RigViewOf(vehicle), 5e-4);
  std::vector<double> out;
  const double w = 2 * std::numbers::pi * 3;
  system.Run(
      [&](double t, std::span<PostState> posts) {
        for (PostState& post : posts)
          post = {amplitude_m * (1 - std::cos(w * t)), amplitude_m * w * std::sin(w * t),
                  amplitude_m * w * w * std::cos(w * t)};
      },
      0, 0.005, [&](double, const Eigen::VectorXd& y) { out.insert(out.end(), y.begin(), y.end()); },
      [&] { return out.size() >= 200 * vehicle.sensors.size(); });
  return out;
}

// To the last bit: while no tyre pulls, its port takes no part.
TEST(CondensedSystem, TakesTyresThatPressForLinearOnes) {
  for (const char* name : {"quarter_car", "landrover110_linkage", "landrover110_model3", "single_wheel_station"}) {
    const auto history = [&](bool lift_off, double amplitude_m) {
      Vehicle vehicle = ShippedVehicle(name);
      for (Tyre& tyre : vehicle.tyres) tyre.lifts_off = lift_off;
      return HistoryOf(vehicle, amplitude_m);
    };
    EXPECT_EQ(history(true, 0.001), history(false, 0.001)) << name;
    EXPECT_NE(history(true, 0.05), history(false, 0.05)) << name;
  }
}

// The full system at motions so small that its kinematics are linear.
TEST(CondensedSystem, IsTheMultibodySystemAtSmallMotions) {
  Prepared car(ShippedVehicle("landrover110_linkage"));
  CondensedSystem condensed(car.model, RigViewOf(car.vehicle), 2e-4);
  MultibodySystem full(car.multibody, 1e-9);
  const auto history = [](TimeSystem& system) {
    std::vector<double> out;
    system.Run(
        [](double t, std::span<PostState> posts) {
          HalfCarPosts(t, posts);
          for (PostState& post : posts) post = {1e-3 * post.height, 1e-3 * post.velocity, 1e-3 * post.acceleration};
        },
        0, 0.01, [&](double, const Eigen::VectorXd& y) { out.insert(out.end(), y.begin(), y.end()); },
        [&] { return out.size() >= 200 * system.rig().sensors.size(); });
    return Eigen::VectorXd(Eigen::Map<Eigen::VectorXd>(out.data(), static_cast<Eigen::Index>(out.size())));
  };
  const Eigen::VectorXd a = history(condensed);
  const Eigen::VectorXd b = history(full);
  const auto sensors = static_cast<Eigen::Index>(car.vehicle.sensors.size());
  using Table = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
  const Table condensed_table(a.data(), 200, sensors);
  const Table full_table(b.data(), 200, sensors);
  for (Eigen::Index i = 0; i < sensors; ++i)
    // Kinematics: micrometres over metres of links. The integrator: 1e-9 of a metre of state, of motions of 8e-6.
    EXPECT_LT((condensed_table.col(i) - full_table.col(i)).norm(), 1e-3 * full_table.col(i).norm())
        << car.vehicle.sensors[static_cast<std::size_t>(i)].name;
}

TEST(CondensedSystem, TellsMotionsThatGrowBeyondAllBounds) {
  CondensedModel model = ThesisHalfCar().Model();
  // Pushes away faster than anything holds.
  model.stiffness(1, 1) = -1e9;
  const RigView rig = ReadAll(model);
  CondensedSystem system(model, rig);
  EXPECT_THROW(system.Run(
                   HalfCarPosts, 0, 0.1, [](double, const Eigen::VectorXd&) {}, [] { return false; }),
               std::runtime_error);
}

TEST(CondensedSystem, RefusesRigsThatAreNotTheModels) {
  CondensedModel model = ThesisHalfCar().Model();
  RigView rig = ReadAll(model);
  EXPECT_THROW(CondensedSystem(model, rig, 0), std::invalid_argument);
  rig.post_count = 4;
  EXPECT_THROW(CondensedSystem(model, rig), std::invalid_argument);
  rig.post_count = 2;
  rig.sensors.pop_back();
  EXPECT_THROW(CondensedSystem(model, rig), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::condensed_system_test
