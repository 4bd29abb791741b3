// Multibody, which computes in Simbody, against DART (dartsim.github.io) on open-loop vehicles.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "tests/independent/dart_tree.h"
#include "tests/independent/dart_vehicle.h"
#include "tests/vehicles/closed_form.h"

namespace fourpost::independent_engine_test {
namespace {

constexpr int kStates = 50;

// Two recursions that share no code round some hundred sums and products at 2^-53 each, and the mass matrix has a
// condition of at most 12 in units of own mass. Up to 5e-15 is reached.
constexpr double kRounding = 1e-13;

/// Of each coordinate, such that alone it has unit mass; so forces, or accelerations, of all kinds compare.
Eigen::VectorXd UnitsOfOwnMass(const Eigen::MatrixXd& mass) { return mass.diagonal().cwiseSqrt().cwiseInverse(); }

/// Only inertia and weight are left.
Vehicle WithoutElements(Vehicle vehicle) {
  vehicle.springs.clear();
  vehicle.dampers.clear();
  vehicle.antiroll_bars.clear();
  vehicle.bushings.clear();
  vehicle.tyres.clear();
  vehicle.posts.clear();
  vehicle.sensors.clear();
  return vehicle;
}

/// Without kinks in its laws, where integrators lose their order.
Vehicle Smooth(Vehicle vehicle) {
  for (Damper& damper : vehicle.dampers) damper.law.rebound = damper.law.compression;
  for (Tyre& tyre : vehicle.tyres) tyre.lifts_off = false;
  return vehicle;
}

DartVehicle RestingInDart(const Vehicle& vehicle) {
  return {vehicle, CondensedVehicle(vehicle).PreloadsAt(vehicle.ParameterValues())};
}

/// M(q) from what accelerations of one coordinate add to the forces: large ones, so that weights do not round it.
Eigen::MatrixXd MassMatrix(Multibody& multibody, const Eigen::VectorXd& state) {
  constexpr double kLarge = 1e4;
  const Eigen::Index n = multibody.coordinate_count();
  const Eigen::VectorXd at_none = multibody.Residual(0, state, Eigen::VectorXd::Zero(2 * n));
  Eigen::MatrixXd mass(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    mass.col(i) = (multibody.Residual(0, state, kLarge * Eigen::VectorXd::Unit(2 * n, n + i)) - at_none) / kLarge;
  return mass;
}

/// Fourth-order Runge-Kutta.
Eigen::VectorXd Integrate(const std::function<Eigen::VectorXd(double t, const Eigen::VectorXd& y)>& derivative,
                          Eigen::VectorXd y, double duration, int steps) {
  const double h = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h;
    const Eigen::VectorXd k1 = derivative(t, y);
    const Eigen::VectorXd k2 = derivative(t + h / 2, y + h / 2 * k1);
    const Eigen::VectorXd k3 = derivative(t + h / 2, y + h / 2 * k2);
    const Eigen::VectorXd k4 = derivative(t + h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return y;
}

/// 10 mm at 3 Hz, each post ahead of the one before.
void Shake(double t, std::span<PostState> posts) {
  constexpr double kAmplitude = 0.01;
  constexpr double kOmega = 2 * std::numbers::pi * 3;
  for (std::size_t i = 0; i < posts.size(); ++i) {
    const double phase = kOmega * t + static_cast<double>(i);
    posts[i] = {.height = kAmplitude * std::sin(phase), .velocity = kAmplitude * kOmega * std::cos(phase)};
  }
}

class IndependentEngine : public testing::TestWithParam<const char*> {
 protected:
  static Vehicle OpenLoopVehicle() {
    Diagnostics diagnostics;
    const std::optional<Vehicle> vehicle =
        ReadVehicle(std::filesystem::path(FOURPOST_SOURCE_DIR) / GetParam(), diagnostics);
    EXPECT_EQ(diagnostics.Format(), "");
    return vehicle.value();
  }

  /// [q u]: angles to 17 degrees, travels to 0.3 m, rates to 3 rad/s and 3 m/s, either way.
  Eigen::VectorXd AnyState(Eigen::Index coordinates) {
    Eigen::VectorXd state(2 * coordinates);
    for (double& q : state.head(coordinates)) q = draw_.Between(-0.3, 0.3);
    for (double& u : state.tail(coordinates)) u = draw_.Between(-3, 3);
    return state;
  }

  std::vector<PostState> AnyPosts(std::size_t count) {
    std::vector<PostState> posts(count);
    for (PostState& post : posts) post = {.height = draw_.Between(-0.05, 0.05), .velocity = draw_.Between(-1, 1)};
    return posts;
  }

 private:
  Draw draw_;
};

TEST_P(IndependentEngine, HasTheSameInertiaWeightAndVelocityForces) {
  const Vehicle vehicle = WithoutElements(OpenLoopVehicle());
  Multibody ours(vehicle);
  DartTree theirs(vehicle);
  const Eigen::Index n = ours.coordinate_count();
  const Eigen::VectorXd no_acceleration = Eigen::VectorXd::Zero(2 * n);
  for (int k = 0; k < kStates; ++k) {
    const Eigen::VectorXd state = AnyState(n);
    Eigen::VectorXd at_rest = state;
    at_rest.tail(n).setZero();
    theirs.SetState(state.head(n), state.tail(n));
    const Eigen::MatrixXd mass = theirs.MassMatrix();
    const Eigen::VectorXd gravity = theirs.GravityForces();
    const Eigen::VectorXd both = gravity + theirs.VelocityForces();
    const Eigen::VectorXd unit = UnitsOfOwnMass(mass);
    const auto units = unit.asDiagonal();
    EXPECT_LT(Deviation(units * MassMatrix(ours, state) * units, units * mass * units), kRounding);
    EXPECT_LT(Deviation(units * ours.Residual(0, at_rest, no_acceleration), units * gravity), kRounding);
    EXPECT_LT(Deviation(units * ours.Residual(0, state, no_acceleration), units * both), kRounding);
  }
}

TEST_P(IndependentEngine, RestsOnTheSamePreloads) {
  const Vehicle vehicle = OpenLoopVehicle();
  const Eigen::VectorXd rest = Multibody(vehicle).RestState();
  const std::vector<PostState> posts(vehicle.posts.size());
  const Eigen::VectorXd derivative = RestingInDart(vehicle).StateDerivative(rest, posts);
  // Rounding of some 10 kN on the smallest inertia, 0.6 kg m^2, in rad/s^2.
  EXPECT_LT(derivative.cwiseAbs().maxCoeff(), 1e-11);
}

TEST_P(IndependentEngine, HasTheSameAccelerations) {
  const Vehicle vehicle = OpenLoopVehicle();
  Multibody ours = Resting(vehicle);
  DartVehicle theirs = RestingInDart(vehicle);
  const Eigen::Index n = ours.coordinate_count();
  for (int k = 0; k < kStates; ++k) {
    const Eigen::VectorXd state = AnyState(n);
    const std::vector<PostState> posts = AnyPosts(vehicle.posts.size());
    ours.SetPostMotion([&](double, std::span<PostState> now) { std::ranges::copy(posts, now.begin()); });
    const Eigen::VectorXd actual = ours.StateDerivative(0, state);
    const Eigen::VectorXd expected = theirs.StateDerivative(state, posts);
    EXPECT_EQ(actual.head(n), expected.head(n));
    const Eigen::VectorXd per_unit = UnitsOfOwnMass(theirs.MassMatrix()).cwiseInverse();
    EXPECT_LT(Deviation(actual.tail(n).cwiseProduct(per_unit), expected.tail(n).cwiseProduct(per_unit)), kRounding);
  }
}

TEST_P(IndependentEngine, TravelsTheSamePath) {
  const Vehicle vehicle = Smooth(OpenLoopVehicle());
  Multibody ours = Resting(vehicle);
  DartVehicle theirs = RestingInDart(vehicle);
  const Eigen::VectorXd start = 0.1 * AnyState(ours.coordinate_count());
  constexpr double kDuration_s = 0.5;
  constexpr int kSteps = 2000;
  constexpr double kAccuracy = 1e-12;  // next to nothing beside what the steps leave

  Eigen::VectorXd end;
  int reports = 0;
  const auto keep = [&](double, const Eigen::VectorXd& state, const Eigen::VectorXd&) {
    end = state;
    ++reports;
  };
  ours.SetPostMotion(Shake);
  ours.Integrate(start, 0, kDuration_s, kAccuracy, keep, [&] { return reports == 2; });

  std::vector<PostState> posts(vehicle.posts.size());
  const auto derivative = [&](double t, const Eigen::VectorXd& state) {
    Shake(t, posts);
    return theirs.StateDerivative(state, posts);
  };
  const Eigen::VectorXd coarse = Integrate(derivative, start, kDuration_s, kSteps / 2);
  const Eigen::VectorXd fine = Integrate(derivative, start, kDuration_s, kSteps);
  // Fourth order: the finer steps leave a fifteenth of what they change (Richardson), but for terms of higher order.
  const double left = (fine - coarse).norm() / 15;
  EXPECT_LT(left, 1e-7 * (end - start).norm()) << "too coarse to tell";
  EXPECT_LT((fine - end).norm(), 1.5 * left);
}

INSTANTIATE_TEST_SUITE_P(OpenLoop, IndependentEngine,
                         testing::Values("urdf/landrover110_linkage.urdf", "urdf/landrover110_model3.urdf",
                                         "tests/independent/three_wheeler.urdf"),
                         [](const auto& vehicle) { return std::filesystem::path(vehicle.param).stem().string(); });

}  // namespace
}  // namespace fourpost::independent_engine_test
