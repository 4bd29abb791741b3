// Forces of Drake's tags, end to end, against their definition in Drake's documentation.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "analysis/text/number.h"
#include "tests/vehicles/element_car.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/gravity.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost::drake_forces_test {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// 50 kg on a vertical slide hang from an inclined spring.
const std::string kHung = R"(<robot name="hung" xmlns:drake="http://drake.mit.edu">
  <link name="ground"/>
  <link name="body"><inertial><mass value="50"/>
    <inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="slide" type="prismatic"><parent link="ground"/><child link="body"/><origin xyz="0 0 1"/>
    <axis xyz="0 0 1"/><limit effort="0" velocity="0"/></joint>
  <drake:linear_spring_damper>
    <drake:linear_spring_damper_body_A name="ground"/>
    <drake:linear_spring_damper_p_AP value="0.3 0 2"/>
    <drake:linear_spring_damper_body_B name="body"/>
    <drake:linear_spring_damper_p_BQ value="0 0 0"/>
    <drake:linear_spring_damper_free_length value="FREE"/>
    <drake:linear_spring_damper_stiffness value="2000"/>
    <drake:linear_spring_damper_damping value="300"/>
  </drake:linear_spring_damper>
</robot>
)";

// Tension = stiffness (length - free_length) + damping length'.
TEST(DrakeForces, SpringDamperPullsByItsLengthAndRate) {
  constexpr double kStiffness = 2000;
  constexpr double kDamping = 300;
  constexpr double kMass = 50;
  // At rest the tension's vertical share, 1 m / length, carries the weight.
  const double length = std::hypot(0.3, 1);
  const double free_length = length - kMass * kGravity * length / kStiffness;
  const Vehicle vehicle = VehicleOf(Replaced(kHung, "FREE", FormatNumber(free_length)));
  Multibody multibody(vehicle);
  multibody.SetParameters({}, CondensedVehicle(vehicle).PreloadsAt({}));
  for (const auto& [up, speed] :
       {std::pair(0.0, 0.0), std::pair(0.1, 0.0), std::pair(-0.2, 0.5), std::pair(0.3, -1.0)}) {
    const double now = std::hypot(0.3, 1 - up);
    const double rate = -(1 - up) / now * speed;
    const double tension = kStiffness * (now - free_length) + kDamping * rate;
    const VectorXd derivative = multibody.StateDerivative(0, Eigen::Vector2d(up, speed));
    EXPECT_NEAR(derivative[1], tension * (1 - up) / now / kMass - kGravity, 1e-12);  // rounding
  }
}

// A body in space on a bushing between two frames that coincide and are turned.
const std::string kMounted = R"(<robot name="mounted" xmlns:drake="http://drake.mit.edu">
  <link name="ground"/>
  <link name="body"><inertial><mass value="2"/>
    <inertia ixx="0.5" iyy="0.5" izz="0.5" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="free" type="floating"><parent link="ground"/><child link="body"/><origin xyz="0.3 0.4 0.5"/></joint>
  <frame name="on_ground" link="ground" xyz="0.3 0.4 0.5" rpy="0.2 0.4 0.7"/>
  <frame name="on_body" link="body" rpy="0.2 0.4 0.7"/>
  <drake:linear_bushing_rpy>
    <drake:bushing_frameA name="on_ground"/>
    <drake:bushing_frameC name="on_body"/>
    <drake:bushing_torque_stiffness value="100 200 300"/>
    <drake:bushing_torque_damping value="4 5 6"/>
    <drake:bushing_force_stiffness value="700 800 900"/>
    <drake:bushing_force_damping value="10 11 12"/>
  </drake:linear_bushing_rpy>
</robot>
)";

// Without turn: force = - stiffness p - damping p', component by component in the frames' axes.
TEST(DrakeForces, BushingResistsTravelAlongItsAxes) {
  const Vehicle vehicle = VehicleOf(kMounted);
  Multibody multibody(vehicle);
  multibody.SetParameters({}, {.bushing = {Vector3d::Zero()}});
  const Matrix3d axes = vehicle.bushings[0].axes;
  const Vector3d travel(0.02, -0.01, 0.03);
  const Vector3d speed(0.4, 0.5, -0.6);
  VectorXd state = multibody.RestState();
  state.segment<3>(3) = travel;
  state.segment<3>(9) = speed;
  const Vector3d p = axes.transpose() * travel;
  const Vector3d v = axes.transpose() * speed;
  const Vector3d force = -axes * Vector3d(700 * p.x() + 10 * v.x(), 800 * p.y() + 11 * v.y(), 900 * p.z() + 12 * v.z());
  const VectorXd derivative = multibody.StateDerivative(0, state);
  EXPECT_LT((derivative.segment<3>(9) - (force / 2 - Vector3d(0, 0, kGravity))).norm(), 1e-12);  // rounding
  EXPECT_LT(derivative.segment<3>(6).norm(), 1e-12);
}

// About one axis, roll, pitch and yaw are the angle: torque = - stiffness q - damping q'.
TEST(DrakeForces, BushingResistsATurnAboutEachOfItsAxes) {
  const Vehicle vehicle = VehicleOf(kMounted);
  Multibody multibody(vehicle);
  multibody.SetParameters({}, {.bushing = {Vector3d::Zero()}});
  const std::array<double, 3> stiffness = {100, 200, 300};
  const std::array<double, 3> damping = {4, 5, 6};
  constexpr double kAngle = 0.01;
  constexpr double kSpeed = 0.2;
  for (Index i = 0; i < 3; ++i) {
    const Vector3d axis = vehicle.bushings[0].axes.col(i);
    // Simbody's coordinates: body-fixed x-y-z angles.
    const Matrix3d turn = Eigen::AngleAxisd(kAngle, axis).toRotationMatrix();
    const Vector3d angles(std::atan2(-turn(1, 2), turn(2, 2)), std::asin(turn(0, 2)),
                          std::atan2(-turn(0, 1), turn(0, 0)));
    VectorXd state = multibody.RestState();
    state.head<3>() = angles;
    multibody.SetPose(state.head(6));
    const Matrix3d by_rates = multibody.LinkJacobian(1).topLeftCorner<3, 3>();
    state.segment<3>(6) = by_rates.inverse() * (kSpeed * axis);
    const VectorXd derivative = multibody.StateDerivative(0, state);
    // Angular acceleration = by_rates u' + d(by_rates)/dt u; by differences along the motion.
    constexpr double kStep = 1e-5;
    const auto spin_at = [&](double t) {
      multibody.SetPose(state.head(6) + t * state.segment(6, 6));
      return Vector3d(multibody.LinkJacobian(1).topLeftCorner<3, 3>() * state.segment<3>(6));
    };
    const Vector3d acceleration =
        by_rates * derivative.segment<3>(6) + (spin_at(kStep) - spin_at(-kStep)) / (2 * kStep);
    const auto k = static_cast<std::size_t>(i);
    const double torque = -(stiffness[k] * kAngle + damping[k] * kSpeed);
    // Twice the sine of half the angle, worked on by its cosine: the angle but for a sixth of its cube, and the square
    // of that cosine at the rate.
    EXPECT_LT((0.5 * acceleration - torque * axis).norm(), 0.5 * kAngle * kAngle * std::abs(torque)) << i;
  }
}

}  // namespace
}  // namespace fourpost::drake_forces_test
