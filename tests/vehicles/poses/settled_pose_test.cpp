#include "vehicles/poses/settled_pose.h"

#include <cmath>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "tests/vehicles/curved_tyres.h"
#include "tests/vehicles/element_car.h"
#include "tests/vehicles/ride_vehicles.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/description/gravity.h"

namespace fourpost::settled_pose_test {
namespace {

// Newton's method closes loops to 1e-12 of metres.
constexpr double kClosed = 1e-9;

SettledPose Settled(const Vehicle& vehicle) { return Settle(vehicle, vehicle.ParameterValues()).value(); }

std::string WithFreeLength(const std::string& length) {
  return Replaced(kTrailingArm, R"(<linear stiffness="80 N/mm"/>)",
                  "<linear stiffness=\"80 N/mm\" free_length=\"" + length + "\"/>");
}

// The chassis, 300 kg, slides upright on a level arm of 0.5 m, whose wheel stays on its platform; 30 kg at 0.4 m of the
// arm; the coil from 0.25 m of the arm to 0.3 m above. After a turn by t, wheel down, the chassis stands 0.5 sin t
// higher: moments about the wheel's foot and the pivot give one equation.
TEST(SettledPose, OfATrailingArmInClosedForm) {
  const auto coil = [](double t) {
    return Eigen::Vector2d(-0.25 * std::cos(t) + 0.25, -0.25 * std::sin(t) - 0.3).norm();
  };
  constexpr double kFree = 0.36;
  // Energy: coil, weights of chassis and arm over the wheel's height.
  const auto energy = [&](double t) {
    return 0.5 * 80e3 * std::pow(coil(t) - kFree, 2) + kGravity * (300 * 0.5 + 30 * 0.1) * std::sin(t);
  };
  double t = 0;
  for (int i = 0; i < 60; ++i) {
    constexpr double h = 1e-4;
    const double slope = (energy(t + h) - energy(t - h)) / (2 * h);
    t -= slope / ((energy(t + h) - 2 * energy(t) + energy(t - h)) / (h * h));
  }
  EXPECT_GT(std::abs(t), 0.02);  // else this tests nothing
  const SettledPose pose = Settled(VehicleOf(WithFreeLength("360 mm")));
  EXPECT_NEAR(pose.rest.at(1).translation().z() - pose.design.at(1).translation().z(), 0.5 * std::sin(t), 1e-7);
  EXPECT_NEAR(pose.springs.at(0).length, coil(t), 1e-7);  // h^2 of the differences
  EXPECT_NEAR(pose.springs[0].force, 80e3 * (pose.springs[0].length - kFree), 1e-6);
  EXPECT_TRUE(pose.tyres.at(0).is_held);
  EXPECT_NEAR(pose.tyres[0].force, 330 * kGravity, 1e-6);
  EXPECT_NEAR(pose.tyres[0].length, pose.tyres[0].design_length, kClosed);
  // The arm's levers in the design pose.
  const double holding = -(330 * 0.5 - 30 * 0.4) * kGravity / 0.25;
  EXPECT_NEAR(pose.springs[0].holding_force.value(), holding, 1e-6);
  EXPECT_NEAR(pose.springs[0].holding_length.value(), 0.3 - holding / 80e3, kClosed);
}

// Drawn under 1.5 kN, a tyre under the whole weight has sunk from there by what its curve says.
TEST(SettledPose, OnATyreCurveIsTheDeflectionUnderTheLoad) {
  for (const bool is_measured : {false, true}) {
    Vehicle vehicle = ShippedVehicle("quarter_car");
    if (is_measured) MeasureTyres(vehicle);
    else MakeProgressive(vehicle, 20, 0.6);
    vehicle.tyres[0].preload = Scalar{.value = 1500};
    const TyreLaw law = vehicle.tyres[0].law.At(vehicle.ParameterValues());
    const SettledPose pose = Settled(vehicle);
    const double sunk = law.Deflection(222 * kGravity) - law.Deflection(1500);
    EXPECT_GT(sunk, 2e-3);
    EXPECT_NEAR(pose.tyres.at(0).length - pose.tyres[0].design_length, sunk, kClosed);
    EXPECT_NEAR(pose.tyres[0].force, 222 * kGravity, 1e-3);  // 1e-9 m times its rate
  }
}

TEST(SettledPose, StaysWhereTheDesignPoseIsAtRest) {
  for (const char* name : {"quarter_car", "independent_roadster", "landrover110"}) {
    const SettledPose pose = Settled(ShippedVehicle(name));
    EXPECT_LT(pose.Shift(), kClosed) << name;
  }
}

// As `check` and all responses have them: on four wheels forces alone do not determine the loads.
TEST(SettledPose, ForcesOfADesignPoseAtRestAreThePreloads) {
  for (const char* name : {"independent_roadster", "landrover110_model3"}) {
    Vehicle vehicle = ShippedVehicle(name);
    // More mass on the left.
    for (Link& link : vehicle.links)
      if (link.mass.At(vehicle.ParameterValues()) > 400) link.com[1] = Scalar{0.05};
    const SettledPose pose = Settled(vehicle);
    const double most = pose.tyres.at(0).holding_force.value();
    EXPECT_GT(std::abs(most - pose.tyres.at(1).holding_force.value()), 10) << name;
    for (const std::vector<SettledPose::Strut>& struts : {pose.springs, pose.tyres})
      for (const SettledPose::Strut& strut : struts) {
        if (!strut.is_held || !strut.holding_force) continue;
        EXPECT_NEAR(strut.force, *strut.holding_force, 1e-6 * most) << strut.element;
      }
  }
}

// Rolling tyres would let it turn about the vertical by degrees, and nothing would turn it back.
TEST(SettledPose, KeepsItsPlaceOnTheGround) {
  Vehicle vehicle = ShippedVehicle("independent_roadster");
  for (Link& link : vehicle.links)
    if (link.name == "body") link.com[1] = Scalar{0.06};
  for (Spring& spring : vehicle.springs)
    if (spring.kind == Spring::Kind::kCoil)
      spring.free_length = Scalar{spring.name.starts_with("front") ? 0.456 : 0.305};
  const SettledPose pose = Settled(vehicle);
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    if (vehicle.links[i].name != "body") continue;
    const Eigen::Matrix3d turn = pose.rest[i].linear() * pose.design[i].linear().transpose();
    EXPECT_GT(std::abs(turn(2, 1)), 0.005);  // else this tests nothing
    // What the arms steer by roll.
    EXPECT_LT(std::abs(turn(1, 0)), 0.002);
    EXPECT_LT((pose.rest[i].translation() - pose.design[i].translation()).head<2>().norm(), 0.02);
  }
  // Nothing pushes sideways.
  double loads = 0;
  for (const SettledPose::Strut& tyre : pose.tyres) loads += tyre.force;
  double mass = 0;
  for (const Link& link : vehicle.links) mass += link.mass.At(vehicle.ParameterValues());
  EXPECT_NEAR(loads, mass * kGravity, 1e-6 * loads);
}

// With the length that it reports the vehicle stays.
TEST(SettledPose, HoldingLengthHoldsTheDesignPose) {
  const double length = Settled(VehicleOf(WithFreeLength("360 mm"))).springs.at(0).holding_length.value();
  char text[64];
  std::snprintf(text, sizeof text, "%.15g m", length);
  EXPECT_LT(Settled(VehicleOf(WithFreeLength(text))).Shift(), kClosed);
}

TEST(SettledPose, IsNoneWhereNothingHolds) {
  std::string text = WithFreeLength("360 mm");
  text = Replaced(text, R"(<linear stiffness="80 N/mm" free_length="360 mm"/>)",
                  R"(<linear stiffness="0 N/mm" preload="-100 N"/>)");
  const Vehicle vehicle = VehicleOf(text);
  EXPECT_FALSE(Settle(vehicle, vehicle.ParameterValues()));
}

}  // namespace
}  // namespace fourpost::settled_pose_test
