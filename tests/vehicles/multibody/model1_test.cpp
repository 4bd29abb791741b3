// The shipped Model 1 in Simbody against the written-out equations, which know nothing of Simbody.
#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include <gmock/gmock.h>

#include "tests/vehicles/closed_form.h"
#include "vehicles/closed_form/half_car.h"

namespace fourpost::model1_test {
namespace {

constexpr int kVehicles = 20;

Vehicle Model1() { return WithLinearTyres(ShippedVehicle("landrover110_model1")); }

/// Thesis 5.1-5.14 with the parameters of the vehicle, both sides together.
HalfCar HalfCarOf(const Vehicle& vehicle) {
  return {.sprung_mass = ValueOf(vehicle, "m_sprung"),
          .pitch_inertia = ValueOf(vehicle, "I_pitch"),
          .front_mass = ValueOf(vehicle, "m_front"),
          .rear_mass = ValueOf(vehicle, "m_rear"),
          .front_stiffness = 2 * ValueOf(vehicle, "k_front"),
          .rear_stiffness = 2 * ValueOf(vehicle, "k_rear"),
          .front_tyre_stiffness = 2 * ValueOf(vehicle, "kt_front"),
          .rear_tyre_stiffness = 2 * ValueOf(vehicle, "kt_rear"),
          .front_damper = {2 * ValueOf(vehicle, "c_front_bump"), 2 * ValueOf(vehicle, "c_front_rebound")},
          .rear_damper = {2 * ValueOf(vehicle, "c_rear_bump"), 2 * ValueOf(vehicle, "c_rear_rebound")},
          .front_length = 1.456,
          .rear_length = 1.338};
}

ClosedForm ClosedFormOf(const Vehicle& vehicle) {
  const HalfCar car = HalfCarOf(vehicle);
  return {.model = car.Model(),
          .acceleration =
              [car](const MotionState& motion) { return car.Acceleration(motion.q, motion.rate, motion.ground); },
          .to_joints = JointOrder(vehicle, {"body_heave", "body_pitch", "front_travel", "rear_travel"})};
}

TEST(Model1, CondensesToTheClosedForm) {
  Draw draw;
  for (int i = 0; i < kVehicles; ++i) {
    const Vehicle vehicle = draw.Parameters(Model1());
    ExpectSameMatrices(vehicle, ClosedFormOf(vehicle));
  }
}

// Without pitch nothing leans, whatever the pitch rate.
TEST(Model1, AcceleratesAsTheClosedFormWhereItIsLevel) {
  Draw draw;
  for (int i = 0; i < kVehicles; ++i) {
    const Vehicle vehicle = draw.Parameters(Model1());
    Multibody multibody = Resting(vehicle);
    MotionState motion = draw.SmallMotion(4, 2);
    motion.q[1] = 0;
    ExpectSameAcceleration(multibody, ClosedFormOf(vehicle), motion);
  }
}

TEST(Model1, AcceleratesAsTheClosedFormForSmallMotion) {
  Draw draw;
  for (int i = 0; i < kVehicles; ++i) {
    const Vehicle vehicle = draw.Parameters(Model1());
    Multibody multibody = Resting(vehicle);
    ExpectSameAccelerationForSmallMotion(multibody, ClosedFormOf(vehicle), draw.SmallMotion(4, 2));
  }
}

/// How the sensors follow from (z_s, theta, z_f, z_r), by the places of the rig's transducers ahead of the front axle.
std::map<std::string, Eigen::RowVectorXd> SensorRows(const HalfCar& car) {
  const auto body = [&](double ahead) { return Eigen::RowVector4d(1, -(ahead + car.front_length), 0, 0); };
  return {{"a_body_front", body(0)},
          {"a_body_rear", body(-2.794)},
          {"a_cross_member", body(0.52)},
          {"a_tow_point", body(-3.62)},
          {"a_cg", body(-1.454)},
          {"a_axle_front", Eigen::RowVector4d(0, 0, 1, 0)},
          {"a_axle_rear", Eigen::RowVector4d(0, 0, 0, 1)},
          {"s_strut_front", Eigen::RowVector4d(1, -car.front_length, -1, 0)},
          {"s_strut_rear", Eigen::RowVector4d(1, car.rear_length, 0, -1)},
          {"F_tyre_front", Eigen::RowVector4d(0, 0, -car.front_tyre_stiffness, 0)},
          {"F_tyre_rear", Eigen::RowVector4d(0, 0, 0, -car.rear_tyre_stiffness)}};
}

TEST(Model1, SensorsReadWhatTheRigsTransducersDo) {
  const Vehicle vehicle = Model1();
  ExpectSensorRows(vehicle, ClosedFormOf(vehicle).to_joints, SensorRows(HalfCarOf(vehicle)));
}

/// What a study sees of a parameter.
auto Facts(const Parameter& p) { return std::tuple(p.name, p.value, p.lower, p.upper, p.precision, p.source); }

// One study serves both.
TEST(Model1, HasTheParametersSensorsAndPostsOfTheLinkageCar) {
  const Vehicle vehicle = Model1();
  const Vehicle linkage = ShippedVehicle("landrover110_linkage");
  ASSERT_EQ(vehicle.parameters.size(), linkage.parameters.size());
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i)
    EXPECT_EQ(Facts(vehicle.parameters[i]), Facts(linkage.parameters[i]));
  const auto same_name = [](const auto& a, const auto& b) { return a.name == b.name; };
  EXPECT_TRUE(std::ranges::equal(vehicle.sensors, linkage.sensors, same_name));
  EXPECT_TRUE(std::ranges::equal(vehicle.tyres, linkage.tyres, same_name));
  EXPECT_TRUE(std::ranges::equal(vehicle.posts, linkage.posts, same_name));
}

}  // namespace
}  // namespace fourpost::model1_test
