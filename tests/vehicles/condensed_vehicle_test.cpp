#include "vehicles/condensed_vehicle.h"

#include <gmock/gmock.h>

#include "analysis/diagnostics.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/harmonic_balance.h"
#include "vehicles/modes.h"
#include "vehicles/multibody.h"

namespace fourpost {
namespace {

using testing::HasSubstr;

/// The linkage car with linear dampers: its state derivative is smooth.
Vehicle SmoothCar() {
  Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  for (const char* name : {"c_front_bump", "c_front_rebound"}) Set(vehicle, name, 2200);
  for (const char* name : {"c_rear_bump", "c_rear_rebound"}) Set(vehicle, name, 2600);
  return vehicle;
}

/// Derivative of the multibody's state derivative at rest, by central differences.
Eigen::MatrixXd DifferencedStateMatrix(const Vehicle& vehicle) {
  Multibody multibody(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  multibody.SetParameters(values, CondensedVehicle(vehicle).PreloadsAt(values));
  const Eigen::VectorXd rest = multibody.RestState();
  Eigen::MatrixXd matrix(rest.size(), rest.size());
  constexpr double kStep = 1e-5;
  for (Eigen::Index j = 0; j < rest.size(); ++j) {
    const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(rest.size(), j);
    matrix.col(j) =
        (multibody.StateDerivative(0, rest + step) - multibody.StateDerivative(0, rest - step)) / (2 * kStep);
  }
  return matrix;
}

void ExpectMultibodysStateMatrix(const Vehicle& vehicle) {
  const Eigen::MatrixXd condensed = StateMatrix(CondensedVehicle(vehicle).At(vehicle.ParameterValues()));
  const Eigen::MatrixXd differenced = DifferencedStateMatrix(vehicle);
  ASSERT_EQ(condensed.rows(), differenced.rows());
  // Differences with a step h: truncation h^2 times third derivatives of order one, rounding eps times 1e3 m/s^2 over
  // h.
  EXPECT_LT((condensed - differenced).cwiseAbs().maxCoeff(), 1e-7 * condensed.cwiseAbs().maxCoeff());
}

TEST(CondensedVehicle, HasTheStateMatrixOfTheMultibody) { ExpectMultibodysStateMatrix(SmoothCar()); }

TEST(CondensedVehicle, HasTheStateMatrixOfTheMultibodyWithASeriesDamper) {
  Vehicle vehicle = SmoothCar();
  vehicle.dampers[1].series_stiffness = Scalar{800e3};
  ExpectMultibodysStateMatrix(vehicle);
}

TEST(CondensedVehicle, HoldsTheDesignPoseAtRest) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const std::vector<double> values = vehicle.ParameterValues();
  Multibody multibody(vehicle);
  multibody.SetParameters(values, CondensedVehicle(vehicle).PreloadsAt(values));
  // Rounding of some 10 kN on 200 kg.
  EXPECT_LT(multibody.StateDerivative(0, multibody.RestState()).norm(), 1e-9);
}

TEST(CondensedVehicle, TyresCarryTheWeight) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const Preloads preloads = CondensedVehicle(vehicle).PreloadsAt(vehicle.ParameterValues());
  double mass = 0;
  for (const Link& link : vehicle.links) mass += link.mass.At(vehicle.ParameterValues());
  double load = 0;
  for (const double tyre : preloads.tyre) load += tyre;
  EXPECT_NEAR(load, mass * 9.80665, 1e-6);  // rounding of 20 kN
}

TEST(CondensedVehicle, FollowsParametersWithoutBeingBuiltAnew) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  Vehicle changed = vehicle;
  for (Parameter& parameter : changed.parameters) parameter.value = 0.5 * (parameter.lower + parameter.upper);
  const CondensedModel moved = CondensedVehicle(vehicle).At(changed.ParameterValues());
  const CondensedModel rebuilt = CondensedVehicle(changed).At(changed.ParameterValues());
  EXPECT_EQ(moved.mass, rebuilt.mass);
  EXPECT_EQ(moved.stiffness, rebuilt.stiffness);
  EXPECT_EQ(moved.preloads.tyre, rebuilt.preloads.tyre);
  EXPECT_NE(moved.stiffness, CondensedVehicle(vehicle).At(vehicle.ParameterValues()).stiffness);
}

/// The linkage car with its front axle free in the plane and held by a ball at the radius arm's bush.
Vehicle CarWithALoop() {
  Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const auto link = [&](const std::string& name) {
    for (std::size_t i = 0; i < vehicle.links.size(); ++i)
      if (vehicle.links[i].name == name) return static_cast<int>(i);
    ADD_FAILURE() << "no link " << name;
    return 0;
  };
  for (Joint& joint : vehicle.joints) {
    if (joint.child != link("front_axle")) continue;
    const Eigen::Vector3d bush = joint.pose.translation();
    vehicle.balls.push_back({.name = "bush", .parent = {joint.parent, bush}, .child = {joint.child, {0, 0, 0}}});
    joint.type = Joint::Type::kPlanar;
    joint.parent = 0;
    // The chassis frame stands at (-1.456, 0, 0.832) in the design pose.
    joint.pose.translation() = bush + Eigen::Vector3d(-1.456, 0, 0.832);
  }
  return vehicle;
}

TEST(CondensedVehicle, ALoopEqualsTheSameJointInATree) {
  const Vehicle tree = ShippedVehicle("landrover110_linkage");
  const Vehicle loop = CarWithALoop();
  const CondensedVehicle tree_condensed(tree);
  const CondensedVehicle loop_condensed(loop);
  ASSERT_EQ(loop_condensed.size(), 4);
  const std::vector<double> values = tree.ParameterValues();
  const Excitation excitation{{0.5, 1.6, 5, 9, 20}, {0.01, 0.01, 0.005, 0.002, 0.001}, {1, -0.5}};
  const FrequencyResponse a = SolveHarmonicBalance(tree_condensed.At(values), tree.sensors, excitation).response;
  const FrequencyResponse b = SolveHarmonicBalance(loop_condensed.At(values), loop.sensors, excitation).response;
  for (std::size_t c = 0; c < tree.sensors.size(); ++c)
    for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i)
      // Second derivatives along the loop's closed poses: differences of projected poses leave 1e-10 of the lengths.
      EXPECT_LT(std::abs(b.channels[c].response[i] / a.channels[c].response[i] - 1.0), 1e-6) << tree.sensors[c].name;
  const Preloads tree_preloads = tree_condensed.PreloadsAt(values);
  const Preloads loop_preloads = loop_condensed.PreloadsAt(values);
  for (std::size_t i = 0; i < tree_preloads.tyre.size(); ++i)
    EXPECT_NEAR(loop_preloads.tyre[i], tree_preloads.tyre[i], 1e-6);  // rounding of 10 kN
}

TEST(CondensedVehicle, NamesALinkThatNothingHolds) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.springs.clear();
  try {
    const CondensedVehicle condensed(vehicle);
    FAIL() << "a car without a spring was held";
  } catch (const FaultyInput& fault) {
    EXPECT_THAT(fault.what(), HasSubstr("can hold the weight of link 'sprung'"));
  }
}

}  // namespace
}  // namespace fourpost
