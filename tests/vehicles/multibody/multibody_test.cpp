#include "vehicles/multibody/multibody.h"

#include <algorithm>
#include <stdexcept>

#include <gmock/gmock.h>

#include "analysis/text/diagnostics.h"
#include "tests/findings.h"
#include "tests/vehicles/resting.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/multibody/findings.h"

namespace fourpost::multibody_test {
namespace {

using testing::HasSubstr;

/// Mid-range values, all different from the file's.
std::vector<double> OtherValues(const Vehicle& vehicle) {
  std::vector<double> values;
  for (const Parameter& parameter : vehicle.parameters) values.push_back(0.4 * parameter.lower + 0.6 * parameter.upper);
  return values;
}

/// Any state that is not at rest.
Eigen::VectorXd SomeState(const Multibody& multibody) {
  Eigen::VectorXd state = multibody.RestState();
  for (Eigen::Index i = 0; i < state.size(); ++i) state[i] += 0.01 * std::sin(1.0 + static_cast<double>(i));
  return state;
}

void ExpectParametersEqualARebuild(const Vehicle& vehicle, const std::vector<double>& values) {
  const Preloads preloads = CondensedVehicle(vehicle).PreloadsAt(values);
  Multibody changed = Resting(vehicle);
  const Eigen::VectorXd state = SomeState(changed);
  const Eigen::VectorXd first = changed.StateDerivative(0, state);
  changed.SetParameters(values, preloads);

  Vehicle other = vehicle;
  for (std::size_t i = 0; i < values.size(); ++i) other.parameters[i].value = values[i];
  Multibody rebuilt(other);
  rebuilt.SetParameters(values, preloads);

  EXPECT_EQ(changed.StateDerivative(0, state), rebuilt.StateDerivative(0, state));
  EXPECT_NE(changed.StateDerivative(0, state), first);
}

void ExpectParametersEqualARebuild(const Vehicle& vehicle) {
  ExpectParametersEqualARebuild(vehicle, OtherValues(vehicle));
}

TEST(Multibody, LoopForcesAreThoseOfItsLoopJacobian) {
  Multibody multibody = Resting(ShippedVehicle("independent_roadster"));
  const Eigen::VectorXd state = SomeState(multibody);
  multibody.SetPose(state.head(multibody.coordinate_count()));
  const Eigen::MatrixXd jacobian = multibody.LoopJacobian();
  ASSERT_GT(jacobian.rows(), 1);
  const Eigen::VectorXd forces = Eigen::VectorXd::LinSpaced(jacobian.rows(), -100, 1000);
  const Eigen::VectorXd expected = jacobian.transpose() * forces;
  // Rounding of sums over some tens of rows.
  EXPECT_LT((multibody.LoopForces(forces) - expected).norm(), 1e-13 * expected.norm());
}

TEST(Multibody, ChangedParametersEqualARebuild) {
  ExpectParametersEqualARebuild(ShippedVehicle("landrover110_linkage"));
}

// Simbody's topology stays as it is.
TEST(Multibody, ChangedRatesEqualARebuild) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const std::vector<double> others = OtherValues(vehicle);
  std::vector<double> values = vehicle.ParameterValues();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (vehicle.parameters[i].name.starts_with("k") || vehicle.parameters[i].name.starts_with("c"))
      values[i] = others[i];
  ExpectParametersEqualARebuild(vehicle, values);
}

TEST(Multibody, ChangedParametersOfASeriesDamperEqualARebuild) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.dampers[0].series = SpringDescription{.stiffness = {.parameter = 2, .factor = 10}};
  ExpectParametersEqualARebuild(vehicle);
}

// Simbody rebuilds the central inertia of a point mass as a difference that rounding turns negative for about one mass
// in ten of this axle.
TEST(Multibody, TakesAnyPointMass) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const CondensedVehicle condensed(vehicle);
  std::vector<double> values = vehicle.ParameterValues();
  const auto front = std::find_if(vehicle.parameters.begin(), vehicle.parameters.end(),
                                  [](const Parameter& parameter) { return parameter.name == "m_front"; });
  ASSERT_NE(front, vehicle.parameters.end());
  Multibody multibody(vehicle);
  for (double mass = front->lower; mass < front->upper; mass += 1.7) {
    values[static_cast<std::size_t>(front - vehicle.parameters.begin())] = mass;
    EXPECT_NO_THROW(multibody.SetParameters(values, condensed.PreloadsAt(values))) << mass;
  }
}

/// Inverse dynamics of the accelerations that forward dynamics give.
void ExpectForwardAndInverseDynamicsAgree(const Vehicle& vehicle) {
  Multibody multibody = Resting(vehicle);
  const Eigen::VectorXd state = SomeState(multibody);
  const Eigen::VectorXd derivative = multibody.StateDerivative(0, state);
  // Rounding of forces of 1e4 N.
  EXPECT_LT(multibody.Residual(0, state, derivative).cwiseAbs().maxCoeff(), 1e-10);
  const Eigen::Index n = multibody.coordinate_count();
  for (Eigen::Index i = n; i < state.size(); ++i) {
    const Eigen::VectorXd other = derivative + Eigen::VectorXd::Unit(state.size(), i);
    EXPECT_GT(std::abs(multibody.Residual(0, state, other)[i - n]), 1) << "no use of derivative " << i;
  }
}

TEST(Multibody, ResidualIsZeroForTheForwardAccelerations) {
  ExpectForwardAndInverseDynamicsAgree(ShippedVehicle("landrover110_linkage"));
}

TEST(Multibody, ResidualIsZeroForTheForwardRatesOfSeriesDampers) {
  Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  for (Damper& damper : vehicle.dampers) damper.series = SpringDescription{.stiffness = {400e3}};
  ExpectForwardAndInverseDynamicsAgree(vehicle);
}

/// Of the accelerations that the forces cause, as of the same ones given.
void ExpectReadingsOfTheAccelerations(const Vehicle& vehicle) {
  Multibody multibody = Resting(vehicle);
  const Eigen::VectorXd state = SomeState(multibody);
  const Eigen::VectorXd derivative = multibody.StateDerivative(0, state);
  const Eigen::VectorXd caused = multibody.Readings(0, state);
  multibody.SetState(0, state);
  // Rounding of accelerations of 1e3 m/s^2 and of tyre forces of 1e4 N.
  EXPECT_LT((multibody.Readings(derivative) - caused).lpNorm<Eigen::Infinity>(), 1e-10);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(state.size());
  EXPECT_GT((multibody.Readings(none) - caused).lpNorm<Eigen::Infinity>(), 1);
}

TEST(Multibody, SensorsReadTheAccelerationsOfATree) {
  ExpectReadingsOfTheAccelerations(ShippedVehicle("landrover110"));
}

TEST(Multibody, SensorsReadTheAccelerationsThroughLoops) {
  ExpectReadingsOfTheAccelerations(ShippedVehicle("landrover110_rigid"));
}

// Of 2 kN on 22 kg.
constexpr double kRounding = 1e-11;

TEST(Multibody, PostsMoveTheTyres) {
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  Multibody multibody = Resting(vehicle);
  multibody.SetPostMotion([](double, std::span<PostState> posts) { posts[0].height = 0.01; });
  const Eigen::VectorXd derivative = multibody.StateDerivative(0, multibody.RestState());
  // kt z / m_u of the thesis's table: 230 kN/m, 10 mm, 22 kg.
  EXPECT_NEAR(derivative.tail(2).maxCoeff(), 230e3 * 0.01 / 22, kRounding);
  multibody.SetPostMotion(nullptr);
  EXPECT_LT(multibody.StateDerivative(0, multibody.RestState()).norm(), kRounding);
}

TEST(Multibody, PostsMoveTheTyresAtAnyTime) {
  const Vehicle vehicle = WithLinearTyres(ShippedVehicle("quarter_car"));
  Multibody multibody = Resting(vehicle);
  multibody.SetPostMotion([](double t, std::span<PostState> posts) { posts[0].height = 0.01 * t; });
  for (const double t : {-1.0, 0.0, 1.0, -1.0})
    // kt z / m_u of the thesis's table: 230 kN/m, 10 mm, 22 kg.
    EXPECT_NEAR(multibody.StateDerivative(t, multibody.RestState()).tail(2).sum(), 230e3 * 0.01 * t / 22, kRounding);
}

TEST(Multibody, KeepsItsPoseThroughNewParameters) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const std::vector<double> values = vehicle.ParameterValues();
  const Preloads preloads = CondensedVehicle(vehicle).PreloadsAt(values);
  Multibody multibody(vehicle);
  const int axle = vehicle.joints.back().child;
  EXPECT_EQ(multibody.LinkPose(axle).translation().x(), -1.456 - 0.444);  // the design pose
  multibody.SetPose(Eigen::Vector4d(0.01, 0.02, -0.03, 0.04));
  const Eigen::Matrix4d pose = multibody.LinkPose(axle).matrix();
  const Eigen::MatrixXd jacobian = multibody.LinkJacobian(axle);
  multibody.SetParameters(values, preloads);
  EXPECT_EQ(multibody.LinkPose(axle).matrix(), pose);
  EXPECT_EQ(multibody.LinkJacobian(axle), jacobian);
}

TEST(Multibody, RefusesWhatHasAnotherSize) {
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  const std::vector<double> values = vehicle.ParameterValues();
  Multibody multibody(vehicle);
  const auto refuses = [](const char* message) {
    return testing::ThrowsMessage<std::invalid_argument>(HasSubstr(message));
  };
  const std::vector<double> few(5, 1);
  EXPECT_THAT(([&] { multibody.SetParameters(few, {{0}, {0}}); }), refuses("each of 6 parameters, has 5"));
  EXPECT_THAT(([&] { multibody.SetParameters(values, {{}, {0}}); }), refuses("each of 1 springs, has 0"));
  EXPECT_THAT(([&] { multibody.SetParameters(values, {{0}, {0, 0}}); }), refuses("each of 1 tyres, has 2"));
  EXPECT_THAT(([&] { multibody.SetPose(Eigen::Vector3d::Zero()); }), refuses("each of 2 coordinates, has 3"));
  EXPECT_THAT(([&] { multibody.StateDerivative(0, Eigen::Vector3d::Zero()); }), refuses("each of 4 states, has 3"));
}

TEST(Multibody, NamesALoopThatCannotBeClosed) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Ball ball;
  ball.name = "too_far";
  ball.parent = {0, {0.5, 0, 0}};
  ball.child = {1, {0, 0, 0}};
  ball.source_line = 17;
  vehicle.balls.push_back(ball);
  try {
    const Multibody multibody(vehicle);
    FAIL() << "the loop was closed";
  } catch (const FaultyInput& fault) {
    // Half a metre to the side; up and down the slider can follow.
    EXPECT_THAT(fault.diagnostics(), Reports(kLoopOpen, 17, {"fp:ball 'too_far'", "583 mm", "500 mm"}));
  }
}

// The ball wants the wheel 0.4 m higher; the rod, which has its length, holds it from the ground.
TEST(Multibody, BlamesOnlyWhatIsOpenAsWritten) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.balls.push_back({.name = "hinge", .parent = {0, {0, 0, 0.7}}, .child = {1, {0, 0, 0}}, .source_line = 17});
  vehicle.rods.push_back({.name = "strap", .parent = {0, {0, 0, 0.1}}, .child = {1, {0, 0, 0}}, .source_line = 18});
  const Diagnostics fault = Fault(vehicle);
  EXPECT_THAT(fault, Reports(kLoopOpen, 17, {"fp:ball 'hinge'", "400 mm"}));
  EXPECT_THAT(fault, Not(Reports(kLoopOpen, {"strap"})));
}

TEST(Multibody, ClosesALoopFromAPoseThatIsOpen) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Ball ball;
  ball.parent = {0, {0, 0, 0.25}};
  ball.child = {1, {0, 0, 0}};
  vehicle.balls.push_back(ball);
  Multibody multibody(vehicle);
  multibody.SetPose(multibody.design_pose());
  EXPECT_NEAR(multibody.LinkPose(1).translation().z(), 0.25, 1e-12);  // the assembly's own threshold
}

}  // namespace
}  // namespace fourpost::multibody_test
