#include "vehicles/loops/chart.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "analysis/text/diagnostics.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/multibody/kinematics.h"

namespace fourpost::chart_test {
namespace {

using testing::HasSubstr;

/// The linkage car, whose axles are also tied to each other by a rod: one coordinate less.
Vehicle TiedCar() {
  Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const auto child = [&](std::size_t joint) { return vehicle.joints[vehicle.joints.size() - joint].child; };
  vehicle.rods.push_back({.name = "tie", .parent = {child(2), {0.2, 0, 0.1}}, .child = {child(1), {-0.3, 0, -0.2}}});
  return vehicle;
}

/// Some pose away from the design.
Eigen::VectorXd SomePose(int size) {
  Eigen::VectorXd s(size);
  for (int i = 0; i < size; ++i) s[i] = 0.02 * std::cos(1.0 + i);
  return s;
}

constexpr double kStep = 1e-5;
// Truncation kStep^2 times third derivatives of order one, rounding of metres over kStep.
constexpr double kTolerance = 1e-9;

/// Value of `measure` at s, by moving the chart there.
template <typename Measure>
double ValueAt(Multibody& multibody, Chart& chart, const Eigen::VectorXd& s, const Measure& measure) {
  const Kinematics pose(multibody, chart.MoveTo(s));
  return measure(pose).value;
}

template <typename Measure>
void ExpectGradientOfDifferences(const Vehicle& vehicle, const Measure& measure) {
  Multibody multibody(vehicle);
  Chart chart(multibody);
  const Eigen::VectorXd s = SomePose(chart.size());
  const Eigen::VectorXd gradient = measure(Kinematics(multibody, chart.MoveTo(s))).gradient;
  ASSERT_EQ(gradient.size(), chart.size());
  for (int i = 0; i < chart.size(); ++i) {
    const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(chart.size(), i);
    const double difference =
        (ValueAt(multibody, chart, s + step, measure) - ValueAt(multibody, chart, s - step, measure)) / (2 * kStep);
    EXPECT_NEAR(gradient[i], difference, kTolerance) << "coordinate " << i;
  }
}

void ExpectGradientsOfDifferences(const Vehicle& vehicle) {
  for (const Spring& spring : vehicle.springs)  // guided by an axis of the parent
    ExpectGradientOfDifferences(vehicle, [&](const Kinematics& pose) { return pose.LineLength(spring.line); });
  for (const Damper& damper : vehicle.dampers)  // the rear one acts along the line between its ends
    ExpectGradientOfDifferences(vehicle, [&](const Kinematics& pose) { return pose.LineLength(damper.line); });
  for (const Tyre& tyre : vehicle.tyres)
    ExpectGradientOfDifferences(
        vehicle, [&](const Kinematics& pose) { return pose.Position(tyre.point, Eigen::Vector3d(0.6, 0, 0.8)); });
}

TEST(Kinematics, HasTheGradientsOfDifferences) { ExpectGradientsOfDifferences(ShippedVehicle("landrover110_linkage")); }

TEST(Kinematics, HasTheGradientsOfDifferencesAlongALoop) { ExpectGradientsOfDifferences(TiedCar()); }

TEST(Kinematics, TurnsALinkAsItsAngularJacobianSays) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const int axle = vehicle.joints.back().child;
  Multibody multibody(vehicle);
  Chart chart(multibody);
  const Eigen::VectorXd s = SomePose(chart.size());
  const Kinematics here(multibody, chart.MoveTo(s));
  for (int i = 0; i < chart.size(); ++i) {
    const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(chart.size(), i);
    const Eigen::Matrix3d after = Kinematics(multibody, chart.MoveTo(s + step)).Rotation(axle);
    const Eigen::Matrix3d before = Kinematics(multibody, chart.MoveTo(s - step)).Rotation(axle);
    // dR/ds = omega x R.
    const Eigen::Matrix3d spin = (after - before) / (2 * kStep) * here.Rotation(axle).transpose();
    const Eigen::Vector3d omega(spin(2, 1), spin(0, 2), spin(1, 0));
    EXPECT_LT((here.AngularJacobian(axle).col(i) - omega).norm(), kTolerance);
  }
}

TEST(Chart, OfATreeIsItsJoints) {
  Multibody multibody(ShippedVehicle("landrover110_linkage"));
  Chart chart(multibody);
  ASSERT_EQ(chart.size(), multibody.coordinate_count());
  EXPECT_EQ(chart.MoveTo(SomePose(4)), Eigen::MatrixXd::Identity(4, 4));
}

TEST(Chart, KeepsItsLoopsClosed) {
  Multibody multibody(TiedCar());
  Chart chart(multibody);
  ASSERT_EQ(chart.size(), multibody.coordinate_count() - 1);
  const Eigen::MatrixXd tangent = chart.MoveTo(SomePose(chart.size()));
  EXPECT_LT(multibody.LoopError().lpNorm<Eigen::Infinity>(), 1e-13);  // where the chart stops
  EXPECT_LT((multibody.LoopJacobian() * tangent).norm(), 1e-12);      // rounding of the solve
}

/// A motion of all coordinates at its own frequencies, at time t: position, or its first or second derivative.
Eigen::VectorXd SomeMotion(int size, double t, int derivative) {
  Eigen::VectorXd s(size);
  for (int i = 0; i < size; ++i) {
    const double w = 2.0 + i;
    s[i] = 0.02 * std::pow(w, derivative) * std::cos(w * t + 1.0 + i + derivative * std::numbers::pi / 2);
  }
  return s;
}

void ExpectRatesOfDifferences(const Vehicle& vehicle) {
  Multibody multibody(vehicle);
  Chart chart(multibody);
  const int n = chart.size();
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(multibody.state_size() - 2 * multibody.coordinate_count());
  const auto at = [&](double t) {
    return chart.Follow(t, SomeMotion(n, t, 0), SomeMotion(n, t, 1), SomeMotion(n, t, 2), at_rest);
  };
  constexpr double kTime = 0.3;
  const Chart::Motion before = at(kTime - kStep);
  const Chart::Motion after = at(kTime + kStep);
  const Chart::Motion now = at(kTime);
  EXPECT_LT((now.rate - (after.q - before.q) / (2 * kStep)).lpNorm<Eigen::Infinity>(), kTolerance);
  // Third derivatives of 0.02 (2 + i)^3.
  EXPECT_LT((now.acceleration - (after.rate - before.rate) / (2 * kStep)).lpNorm<Eigen::Infinity>(), 10 * kTolerance);
}

TEST(Chart, FollowsAMotionOfATree) { ExpectRatesOfDifferences(ShippedVehicle("landrover110_model1")); }

TEST(Chart, FollowsAMotionThroughALoop) { ExpectRatesOfDifferences(TiedCar()); }

TEST(Chart, FollowsAMotionThroughManyLoops) { ExpectRatesOfDifferences(ShippedVehicle("landrover110_rigid")); }

// A horizontal rod to a wheel that only moves up and down gives way at first, but not to any motion.
TEST(Chart, TellsThatTheLoopsLockTheVehicle) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.rods.push_back({.name = "dead_centre", .parent = {0, {0.5, 0, 0.3}}, .child = {1, {0, 0, 0}}});
  Multibody multibody(vehicle);
  Chart chart(multibody);
  ASSERT_EQ(chart.size(), 2);
  try {
    chart.MoveTo(Eigen::Vector2d(1e-3, 1e-3));
    FAIL() << "the rod followed";
  } catch (const FaultyInput& fault) {
    EXPECT_THAT(fault.what(), HasSubstr("the loops lock the vehicle"));
  }
}

}  // namespace
}  // namespace fourpost::chart_test
