#include "vehicles/condensed/condensed_vehicle.h"

#include <algorithm>
#include <stdexcept>

#include <gmock/gmock.h>

#include "analysis/text/diagnostics.h"
#include "tests/findings.h"
#include "tests/vehicles/curved_tyres.h"
#include "tests/vehicles/resting.h"
#include "tests/vehicles/same_model.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/findings.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost::condensed_vehicle_test {
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
  Multibody multibody = Resting(vehicle);
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

TEST(CondensedVehicle, HasTheStateMatrixOfTheMultibodyOnTyreCurves) {
  Vehicle vehicle = SmoothCar();
  MakeProgressive(vehicle, 8);
  ExpectMultibodysStateMatrix(vehicle);
  vehicle = SmoothCar();
  MeasureTyres(vehicle);
  ExpectMultibodysStateMatrix(vehicle);
}

// A linear tyre of the rate load / deflection stores another energy, but its least is at the same preloads: there the
// deflections are the same.
TEST(CondensedVehicle, SharesTheWeightByTheEnergyOfTyreCurves) {
  Vehicle vehicle = ShippedVehicle("landrover110_model3");
  Set(vehicle, "y_body", 0.05);
  Set(vehicle, "y_front", -0.03);
  Set(vehicle, "k_FL", 30e3);
  MakeProgressive(vehicle, 20, 0.4);
  const std::vector<double> values = vehicle.ParameterValues();
  const std::vector<double> loads = CondensedVehicle(vehicle).PreloadsAt(values).tyre;
  Vehicle secant = vehicle;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const TyreLaw law = vehicle.tyres[i].law.At(values);
    secant.tyres[i].law = {.stiffness = {loads[i] / law.Deflection(loads[i])}};
    // Else the test tells nothing.
    EXPECT_GT(law.Under(loads[i]).Rate(0), 1.2 * loads[i] / law.Deflection(loads[i]));
  }
  const std::vector<double> expected = CondensedVehicle(secant).PreloadsAt(values).tyre;
  for (std::size_t i = 0; i < loads.size(); ++i) EXPECT_NEAR(loads[i], expected[i], 1e-8 * loads[i]);  // rounding
}

TEST(CondensedVehicle, HasTheStateMatrixOfTheMultibodyWithASeriesDamper) {
  Vehicle vehicle = SmoothCar();
  vehicle.dampers[1].series = SpringDescription{.stiffness = {800e3}};
  ExpectMultibodysStateMatrix(vehicle);
}

TEST(CondensedVehicle, HoldsTheDesignPoseAtRest) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  Multibody multibody = Resting(vehicle);
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
  EXPECT_NEAR(load, mass * 9.80665, 1e-10);  // rounding of 20 kN
}

TEST(CondensedVehicle, FollowsParametersWithoutBeingBuiltAnew) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  Vehicle changed = vehicle;
  for (Parameter& parameter : changed.parameters) parameter.value = 0.5 * (parameter.lower + parameter.upper);
  const CondensedModel moved = CondensedVehicle(vehicle).At(changed.ParameterValues());
  const CondensedModel rebuilt = CondensedVehicle(changed).At(changed.ParameterValues());
  ExpectSameModel(moved, rebuilt);
  EXPECT_NE(moved.stiffness, CondensedVehicle(vehicle).At(vehicle.ParameterValues()).stiffness);
}

// The chassis frame in the design pose.
const Eigen::Vector3d kChassis(-1.456, 0, 0.832);

/// The linkage car with its front axle free in the plane and held by a ball at the radius arm's bush.
Vehicle CarWithABall() {
  Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  for (Joint& joint : vehicle.joints) {
    if (joint.child != LinkOf(vehicle, "front_axle")) continue;
    const Eigen::Vector3d bush = joint.pose.translation();
    vehicle.balls.push_back({.name = "bush", .parent = {joint.parent, bush}, .child = {joint.child, {0, 0, 0}}});
    joint.type = Joint::Type::kPlanar;
    joint.parent = 0;
    joint.pose.translation() = bush + kChassis;
  }
  return vehicle;
}

/// Gives a link its frame at `origin` of the former one.
void MoveFrame(Vehicle& vehicle, int link, const Eigen::Vector3d& origin) {
  const auto move = [&](Point& point) {
    if (point.link == link) point.xyz -= origin;
  };
  for (Eigen::Index i = 0; i < 3; ++i)
    vehicle.links[static_cast<std::size_t>(link)].com[static_cast<std::size_t>(i)].value -= origin[i];
  for (Spring& spring : vehicle.springs) move(spring.line.child);
  for (Damper& damper : vehicle.dampers) move(damper.line.child);
  for (Tyre& tyre : vehicle.tyres) move(tyre.point);
  for (Sensor& sensor : vehicle.sensors) {
    move(sensor.point);
    move(sensor.line.child);
  }
}

/// The linkage car with its front axle free to shift in the plane and held by a rod from its centre to the radius arm's
/// bush: a point mass moves on the rod as on the arm.
Vehicle CarWithARod() {
  Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const int axle = LinkOf(vehicle, "front_axle");
  const Eigen::Vector3d centre = vehicle.links[static_cast<std::size_t>(axle)].ComAt({});
  MoveFrame(vehicle, axle, centre);
  vehicle.links.push_back({.name = "fore_aft"});
  const int slide = static_cast<int>(vehicle.links.size()) - 1;
  const auto arm = std::find_if(vehicle.joints.begin(), vehicle.joints.end(),
                                [&](const Joint& joint) { return joint.child == axle; });
  const Eigen::Vector3d bush = arm->pose.translation();
  vehicle.rods.push_back({.name = "radius_rod", .parent = {arm->parent, bush}, .child = {axle, {0, 0, 0}}});
  Joint fore_aft{.name = "fore_aft", .type = Joint::Type::kPrismatic, .parent = 0, .child = slide};
  fore_aft.pose.translation() = kChassis + bush + centre;
  *arm = {
      .name = "hop", .type = Joint::Type::kPrismatic, .parent = slide, .child = axle, .axis = Eigen::Vector3d::UnitZ()};
  vehicle.joints.insert(arm, fore_aft);
  return vehicle;
}

void ExpectLoopEqualsTree(const Vehicle& loop) {
  const Vehicle tree = ShippedVehicle("landrover110_linkage");
  const CondensedVehicle tree_condensed(tree);
  const CondensedVehicle loop_condensed(loop);
  ASSERT_EQ(loop_condensed.size(), 4);
  const std::vector<double> values = tree.ParameterValues();
  const Excitation excitation{{0.5, 1.6, 5, 9, 20}, {0.01, 0.01, 0.005, 0.002, 0.001}, {1, -0.5}};
  const FrequencyResponse a = SolveHarmonicBalance(tree_condensed.At(values), tree.sensors, excitation).response;
  const FrequencyResponse b = SolveHarmonicBalance(loop_condensed.At(values), loop.sensors, excitation).response;
  for (std::size_t c = 0; c < tree.sensors.size(); ++c)
    for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i)
      // Second derivatives along the loop's closed poses: differences of projected poses leave 1e-10 / m of 10 kN
      // beside rates of 100 kN/m, which resonance and nodes magnify a hundredfold.
      EXPECT_LT(std::abs(b.channels[c].response[i] / a.channels[c].response[i] - 1.0), 1e-9) << tree.sensors[c].name;
  const Preloads tree_preloads = tree_condensed.PreloadsAt(values);
  const Preloads loop_preloads = loop_condensed.PreloadsAt(values);
  for (std::size_t i = 0; i < tree_preloads.tyre.size(); ++i)
    EXPECT_NEAR(loop_preloads.tyre[i], tree_preloads.tyre[i], 1e-10);  // rounding of 10 kN
}

TEST(CondensedVehicle, ABallEqualsTheSameJointInATree) { ExpectLoopEqualsTree(CarWithABall()); }

TEST(CondensedVehicle, ARodToAPointMassEqualsTheArmInATree) { ExpectLoopEqualsTree(CarWithARod()); }

// Forces of the loop act in the marched equations only.
TEST(CondensedVehicle, RestsOnARodInTheMultibody) {
  const Vehicle vehicle = CarWithARod();
  Multibody multibody = Resting(vehicle);
  // Rounding of some 10 kN on 200 kg.
  EXPECT_LT(multibody.StateDerivative(0, multibody.RestState()).norm(), 1e-9);
}

TEST(CondensedVehicle, TellsThatNothingCanMove) {
  Vehicle welded = ShippedVehicle("quarter_car");
  for (Joint& joint : welded.joints) joint.type = Joint::Type::kFixed;
  EXPECT_THAT(Fault(welded), Reports(kNothingMoves));
  Vehicle hung = ShippedVehicle("quarter_car");
  for (const int link : {1, 2})
    hung.rods.push_back({.name = "r", .parent = {0, {0, 0, 2}}, .child = {link, {0, 0, 0}}});
  EXPECT_THAT(Fault(hung), Reports(kNothingMoves));
}

TEST(CondensedVehicle, TellsThatItsLoopsLockIt) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.rods.push_back({.name = "dead_centre", .parent = {0, {0.5, 0, 0.3}}, .child = {1, {0, 0, 0}}});
  EXPECT_THAT(Fault(vehicle).items(),
              testing::Contains(testing::Field(&Diagnostic::id, testing::StartsWith("loops-"))));
}

TEST(CondensedVehicle, NeedsAValueForEachParameter) {
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  const CondensedVehicle condensed(vehicle);
  const std::vector<double> few(5, 1);
  const auto refuses = testing::ThrowsMessage<std::invalid_argument>(HasSubstr("each of 6 parameters, has 5"));
  EXPECT_THAT([&] { condensed.At(few); }, refuses);
  EXPECT_THAT([&] { condensed.PreloadsAt(few); }, refuses);
  EXPECT_THAT([&] { condensed.LinkMotions(few); }, refuses);
}

TEST(CondensedVehicle, NamesAMotionThatNothingHolds) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.springs.clear();
  EXPECT_THAT(Fault(vehicle), Reports(kUnheldDamper, {"heave of link 'sprung'"}));
}

}  // namespace
}  // namespace fourpost::condensed_vehicle_test
