// The Land Rover with its power unit on mounts: statics, freedoms, modes, and its condensed model against Simbody.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/vehicles/lint_all.h"
#include "tests/vehicles/recorded_rig.h"
#include "tests/vehicles/response/mode_band.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/description/added_mass.h"
#include "vehicles/description/design_poses.h"
#include "vehicles/description/gravity.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost::landrover110_engine_test {
namespace {

const char* const kCar = "landrover110_engine";

/// Sum of the tyres' loads times their places (x, y), and the sum alone (z).
Eigen::Vector3d Borne(const Vehicle& vehicle) {
  const Preloads preloads = CondensedVehicle(vehicle).PreloadsAt(vehicle.ParameterValues());
  const std::vector<Eigen::Isometry3d> poses = DesignPoses(vehicle);
  Eigen::Vector3d borne = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < vehicle.tyres.size(); ++i) {
    const Eigen::Vector3d place = PlaceOf(vehicle.tyres[i].point, poses);
    borne += preloads.tyre[i] * Eigen::Vector3d(place.x(), place.y(), 1);
  }
  return borne;
}

TEST(Landrover110Engine, RestsInItsDesignPose) {
  const Vehicle vehicle = ShippedVehicle(kCar);
  Multibody multibody = Prepared(vehicle).multibody;
  // Rounding of forces of some 10 kN on the least inertia, 0.2 kg m^2.
  EXPECT_LT(multibody.StateDerivative(0, multibody.RestState()).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_EQ(Lint(vehicle).Format(), "");
}

TEST(Landrover110Engine, TyresBearTheWeightWhereItIs) {
  Vehicle vehicle = ShippedVehicle(kCar);
  Set(vehicle, "y_body", 0.03);
  Set(vehicle, "y_rear", -0.02);
  const std::vector<double> values = vehicle.ParameterValues();
  const std::vector<Eigen::Isometry3d> poses = DesignPoses(vehicle);
  Eigen::Vector3d weight = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i < vehicle.links.size(); ++i) {
    const Eigen::Vector3d place = poses[i] * vehicle.links[i].ComAt(values);
    weight += kGravity * vehicle.links[i].mass.At(values) * Eigen::Vector3d(place.x(), place.y(), 1);
  }
  // Chassis, power unit, axles, A-frame, Panhard rod and trailing links.
  EXPECT_DOUBLE_EQ(weight.z(), kGravity * (1425 + 300 + 220 + 220 + 8 + 2 + 4));
  // Rounding.
  EXPECT_LT((Borne(vehicle) - weight).norm(), 1e-12 * weight.norm());
}

TEST(Landrover110Engine, BearsALoadWhereItLies) {
  const Vehicle vehicle = ShippedVehicle(kCar);
  const Vehicle loaded = WithMass(vehicle, vehicle.ParameterValues(), 250, {-2, 0.3, 1});
  const Eigen::Vector3d more = Borne(loaded) - Borne(vehicle);
  // Rounding of the whole weight.
  EXPECT_LT((more - 250 * kGravity * Eigen::Vector3d(-2, 0.3, 1)).norm(), 1e-12 * Borne(vehicle).norm());
}

TEST(Landrover110Engine, MovesAtFrequenciesOfACar) {
  const std::array<ModeBand, 9> kBands = {{{"heave", 1, 2},
                                           {"pitch", 1, 2.5},
                                           {"roll", 0.9, 3.5},
                                           {"front hop", 8, 13},
                                           {"rear hop", 8, 13},
                                           {"front tramp", 8, 15},
                                           {"rear tramp", 8, 15},
                                           // An engine on rubber.
                                           {"power_unit heave", 10, 25},
                                           {"power_unit pitch", 10, 25}}};
  const Vehicle vehicle = ShippedVehicle(kCar);
  const VehicleSummary summary = Summarise(vehicle, vehicle.ParameterValues());
  EXPECT_EQ(summary.dof, 33);
  for (const Mode& mode : summary.modes) {
    EXPECT_EQ(mode.kind, Mode::Kind::kOscillating) << mode.name;
    EXPECT_GT(mode.damping_ratio, 0.02) << mode.name;
  }
  ExpectWithin(kBands, summary);
}

// For small motion of the posts; geometry bends more for larger.
TEST(Landrover110Engine, MovesInSimbodyAsItsCondensedModel) {
  constexpr double kScale = 1e-3;
  Prepared car(ShippedVehicle(kCar));
  const Excitation all = RecordedExcitation("bounce_frf.csv", PostPattern(car.vehicle, "heave"), kScale);
  const Excitation excitation = Only(all, {0, 20, 40, 63});
  ExpectAgreement(car.Linearised(excitation).response, car.Full(excitation).response, 1e-3, 5e-3);
}

/// Largest modelled gain of a channel between 1 and 3 Hz.
double LargestGain(const Vehicle& vehicle, const char* pattern, const std::string& channel) {
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const Excitation excitation{{1, 1.5, 2, 2.5, 3}, {0.01, 0.01, 0.01, 0.01, 0.01}, PostPattern(vehicle, pattern)};
  const FrequencyResponse response = SolveHarmonicBalance(model, vehicle.sensors, excitation).response;
  double largest = 0;
  for (const ChannelResponse& each : response.channels)
    for (const std::complex<double>& value : each.response)
      if (each.name == channel) largest = std::max(largest, std::abs(value));
  return largest;
}

// Warp twists the axles against each other, whose moments on the body nearly cancel; roll takes it along. Told at a
// corner: the centre of gravity is nearly a node of both.
TEST(Landrover110Engine, BodyRollsLessInWarpThanInRoll) {
  const Vehicle vehicle = ShippedVehicle(kCar);
  const double roll = LargestGain(vehicle, "roll", "a_body_FL");
  EXPECT_GT(roll, 2);
  // 0.40 (2.0 over 5.1); 1 of a body that warp took along as roll does.
  EXPECT_LT(LargestGain(vehicle, "warp", "a_body_FL"), 0.5 * roll);
  // Struts move as the axles do.
  EXPECT_GT(LargestGain(vehicle, "warp", "s_strut_RL"), 0.3);
}

}  // namespace
}  // namespace fourpost::landrover110_engine_test
