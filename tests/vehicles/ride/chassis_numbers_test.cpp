#include "vehicles/ride/chassis_numbers.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/rounding.h"
#include "tests/vehicles/element_car.h"
#include "tests/vehicles/poses/axle_cars.h"
#include "tests/vehicles/ride_vehicles.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/description/gravity.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost::chassis_numbers_test {
namespace {

// Second derivatives by differences over millimetres keep 1e-10 of loads of some kN; rates are some kN/m.
constexpr double kShare = 1e-8;

void ExpectShare(const std::optional<double>& value, double expected) {
  ASSERT_TRUE(value);
  EXPECT_NEAR(*value / expected, 1, kShare);
}

ChassisNumbers NumbersOf(const Vehicle& vehicle) { return Summarise(vehicle, vehicle.ParameterValues()).chassis; }

/// On the ground.
std::string StandingCar() {
  std::string text = kIndependentCar;
  for (const std::string axle : {"front", "rear"})
    text = Replaced(text, "link=\"" + axle + "_left\" xyz=\"-0.4 0 0\" stiffness",
                    "radius=\"0.3 m\" link=\"" + axle + "_left\" xyz=\"-0.4 0 0\" stiffness");
  return text;
}

// Level trailing arms of 0.4 m; coils and dampers upright over the wheel centres at (0 and -2.6, +-0.7, 0.3); arms'
// masses there, the body's at (-1.2, 0, 0.55).
TEST(ChassisNumbers, OfACarOnTrailingArmsByHand) {
  const ChassisNumbers numbers = NumbersOf(VehicleOf(StandingCar()));
  const double mass = 1200 + 80 + 90;
  const double height = (1200 * 0.55 + 170 * 0.3) / mass;
  const double x = -(1200 * 1.2 + 90 * 2.6) / mass;
  const double front_load = mass * kGravity * (1 + x / 2.6);
  const double rear_load = mass * kGravity - front_load;
  const AxleNumbers& front = numbers.axles.at(0);
  const AxleNumbers& rear = numbers.axles.at(1);
  ExpectShare(numbers.wheelbase_m, 2.6);
  ExpectShare(numbers.com_height_m, height);
  ExpectShare(front.load_N, front_load);
  ExpectShare(front.unsprung_kg, 80);
  const double front_sprung = front_load / kGravity - 80;
  ExpectShare(front.sprung_kg, front_sprung);
  constexpr double k2Pi = 2 * std::numbers::pi;
  ExpectShare(front.ride_Hz, std::sqrt(2 * 30e3 * 200e3 / 230e3 / front_sprung) / k2Pi);
  ExpectShare(front.hop_Hz, std::sqrt(2 * 230e3 / 80.0) / k2Pi);
  ExpectShare(rear.hop_Hz, std::sqrt(2 * 245e3 / 90.0) / k2Pi);
  const double front_roll = 2 * 30e3 * 0.49 + 10e3 * 1.96;
  const double rear_roll = 2 * 35e3 * 0.49;
  ExpectShare(front.elastic_roll_Nm, front_roll);
  ExpectShare(rear.elastic_roll_Nm, rear_roll);
  const double front_tyres = 2 * 200e3 * 0.49;
  const double rear_tyres = 2 * 210e3 * 0.49;
  const double front_on_tyres = front_roll * front_tyres / (front_roll + front_tyres);
  const double rear_on_tyres = rear_roll * rear_tyres / (rear_roll + rear_tyres);
  ExpectShare(front.roll_on_tyres_Nm, front_on_tyres);
  // Feet go straight up.
  EXPECT_NEAR(front.roll_centre_m.value(), 0, 1e-12);
  ExpectShare(numbers.roll_arm_m, 0.55);
  // The arms lean with the body.
  const double moment = 1200 * 0.55 + 170 * 0.3;
  const double gradient = moment / (front_on_tyres + rear_on_tyres - moment * kGravity);
  ExpectShare(numbers.roll_gradient, gradient);
  const double front_transfer = (front_on_tyres * gradient) / 1.4;
  const double rear_transfer = (rear_on_tyres * gradient) / 1.4;
  ExpectShare(front.load_transfer, front_transfer);
  ExpectShare(rear.load_transfer_share, rear_transfer / (front_transfer + rear_transfer));
  // All moments about the ground: of the masses' inertia, and of the weight that has moved aside.
  EXPECT_NEAR((front_transfer + rear_transfer) * 1.4 / (mass * height + moment * kGravity * gradient), 1, kShare);
  // A rise turns the arm by 1 / 0.4, which takes a locked wheel's foot back by 0.3 / 0.4; pro-dive, anti-lift.
  const double support = 0.75 * 2.6 / height;
  ExpectShare(front.anti_braking, -support * front_load / (front_load + rear_load));
  ExpectShare(rear.anti_braking, support * rear_load / (front_load + rear_load));
  EXPECT_NEAR(rear.anti_driving.value(), 0, 1e-12);  // its centre goes straight up
  EXPECT_FALSE(front.is_beam);
  EXPECT_FALSE(numbers.pitch_centre) << "parallel arms";
  ExpectShare(numbers.cross_weight, 0.5);
  const CornerNumbers& corner = numbers.corners.at(0);
  ExpectShare(corner.sprung_kg, front_sprung / 2);
  ExpectShare(corner.bump_Nspm, 1000);
  ExpectShare(corner.rebound_ratio, 2000 / (2 * std::sqrt(30e3 * front_sprung / 2)));
}

/// Two level lower rods at 0.3 m, an upper one that falls by 0.05 m over 0.5 m from 0.5 m, a level Panhard rod at 0.4
/// m; the rods of the front axle lead back, those of the rear one ahead.
std::string BeamWithRods(const std::string& axle, double x, double ahead) {
  using axle_cars::Vec;
  const auto rod = [&](const std::string& name, const Vec& body, const Vec& beam) {
    return axle_cars::Rod(axle + name, axle, body, beam);
  };
  return axle_cars::Body(axle, 100) + "<joint name=\"" + axle +
         "\" type=\"floating\"><parent link=\"ground\"/><child link=\"" + axle + "\"/></joint>\n" +
         rod("_lower_left", {x + ahead, 0.4, 0.3}, {x, 0.4, 0.3}) +
         rod("_lower_right", {x + ahead, -0.4, 0.3}, {x, -0.4, 0.3}) +
         rod("_upper", {x + ahead, 0, 0.45}, {x, 0, 0.5}) + rod("_panhard", {x, -0.4, 0.4}, {x, 0.4, 0.4}) +
         axle_cars::Coil(axle + "_left", axle, {x, 0.5, 0.8}, {x, 0.5, 0.4}) +
         axle_cars::Coil(axle + "_right", axle, {x, -0.5, 0.8}, {x, -0.5, 0.4}) +
         axle_cars::Tyre(axle + "_left", axle, {x, 0.75, 0.3}) +
         axle_cars::Tyre(axle + "_right", axle, {x, -0.75, 0.3});
}

std::string BeamCar() {
  return R"(<?xml version="1.0"?>
<robot name="beams" xmlns:fp="urn:fourpost:vehicle:1">
<link name="ground"/>
<link name="body"><inertial><origin xyz="-1.1 0.05 0.7"/><mass value="1000"/>
<inertia ixx="300" ixy="0" ixz="0" iyy="1200" iyz="0" izz="1300"/></inertial></link>
<joint name="body" type="floating"><parent link="ground"/><child link="body"/></joint>
)" + BeamWithRods("front", 0, -0.5) +
         BeamWithRods("rear", -2.6, 0.5) + "</robot>\n";
}

TEST(ChassisNumbers, OfBeamAxlesByHand) {
  std::string text = BeamCar();
  // The beams' masses at their middle, 0.3 m high.
  for (const std::string axle : {"front", "rear"}) {
    const std::string link = "<link name=\"" + axle + "\"><inertial>";
    text = Replaced(text, link, link + "<origin xyz=\"" + (axle == "front" ? "0" : "-2.6") + " 0 0.3\"/>");
  }
  const ChassisNumbers numbers = NumbersOf(VehicleOf(text));
  const AxleNumbers& front = numbers.axles.at(0);
  const AxleNumbers& rear = numbers.axles.at(1);
  EXPECT_TRUE(front.is_beam);
  EXPECT_NEAR(front.roll_centre_m.value(), 0.4, 1e-9);  // rounding of the solved travel
  EXPECT_NEAR(rear.roll_centre_m.value(), 0.4, 1e-9);
  ExpectShare(front.elastic_roll_Nm, 2 * 30e3 * 0.25);
  const double height = (1000 * 0.7 + 200 * 0.3) / 1200;
  const double front_share = 1 - (1000 * 1.1 + 100 * 2.6) / 1200 / 2.6;
  // Side-view centres lie 2 m inward, 0.3 m high.
  ExpectShare(front.braking_support, 0.15);
  ExpectShare(rear.braking_support, 0.15);
  ExpectShare(rear.driving_support, 0.15);
  ExpectShare(front.anti_braking, 0.15 * 2.6 / height * front_share);
  ExpectShare(rear.anti_driving, 0.15 * 2.6 / height);
  ASSERT_TRUE(numbers.pitch_centre);
  EXPECT_NEAR(numbers.pitch_centre->x, -1.3, 1e-9);
  EXPECT_NEAR(numbers.pitch_centre->z, 0.15 * 1.3, 1e-9);
  ExpectShare(numbers.left_share, 0.5 + 1000 * 0.05 / 1200 / 1.5);
  ExpectShare(numbers.roll_arm_m, 0.3);
}

/// Roll of the body per lateral acceleration in static equilibrium of the reduced model.
double RollOfTheModel(const Vehicle& vehicle) {
  const std::vector<double> values = vehicle.ParameterValues();
  const CondensedVehicle condensed(vehicle);
  const CondensedModel model = condensed.At(values);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(model.mass.rows());
  for (const LinkMotion& link : condensed.LinkMotions(values))
    force -= link.mass * link.com_jacobian.row(1).transpose();
  const Eigen::VectorXd motion = model.stiffness.fullPivLu().solve(force);
  for (const LinkMotion& link : condensed.LinkMotions(values))
    if (link.name == "body") return link.spin_jacobian.row(0).dot(motion);
  return kNan;
}

// Trailing arms leave nothing out. Wishbones change camber under the loads, which the calculation by roll centres does
// not know.
TEST(ChassisNumbers, RollGradientIsThatOfTheReducedModel) {
  const Vehicle arms = VehicleOf(StandingCar());
  EXPECT_NEAR(RollOfTheModel(arms) / NumbersOf(arms).roll_gradient.value(), 1, kShare);
  const Vehicle roadster = ShippedVehicle("independent_roadster");
  EXPECT_NEAR(RollOfTheModel(roadster) / NumbersOf(roadster).roll_gradient.value(), 1, 0.05);
}

TEST(ChassisNumbers, AreLeftOutWhereJointsGuideTheChassisOrFeetAreInTheAir) {
  for (const char* name : {"landrover110_model1", "landrover110_model3", "landrover110_linkage"}) {
    const ChassisNumbers numbers = NumbersOf(ShippedVehicle(name));
    EXPECT_FALSE(numbers.roll_gradient) << name;
    EXPECT_FALSE(numbers.axles.at(0).anti_braking) << name;
    EXPECT_TRUE(numbers.axles[0].ride_Hz) << name;
  }
}

}  // namespace
}  // namespace fourpost::chassis_numbers_test
