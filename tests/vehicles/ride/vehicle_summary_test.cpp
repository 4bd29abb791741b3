#include "vehicles/ride/vehicle_summary.h"

#include <gtest/gtest.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/description/gravity.h"

namespace fourpost::vehicle_summary_test {
namespace {

// Of some 20 kN.
constexpr double kForceRounding = 1e-10;

TEST(VehicleSummary, HasTheQuarterCarsMassesAndLoad) {
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  const VehicleSummary summary = Summarise(vehicle, vehicle.ParameterValues());
  EXPECT_EQ(summary.dof, 2);
  EXPECT_EQ(summary.mass_kg, 222);
  // 200 kg at 0.7 m, 22 kg at 0.3 m.
  EXPECT_LT((summary.com - Eigen::Vector3d(0, 0, (200 * 0.7 + 22 * 0.3) / 222)).norm(), 1e-15);  // rounding
  ASSERT_EQ(summary.corner_loads.size(), 1u);
  EXPECT_EQ(summary.corner_loads[0].tyre, "tyre");
  EXPECT_NEAR(summary.corner_loads[0].load_N, 222 * kGravity, kForceRounding);
  EXPECT_EQ(summary.modes.size(), 2u);
}

// Front and rear axle 220 kg each at 0.385 m, body 1725 kg at x -1.456 m and 0.832 m, with its own inertia.
TEST(VehicleSummary, AddsTheInertiaOfAllBodies) {
  const Vehicle vehicle = ShippedVehicle("landrover110_model3");
  const VehicleSummary summary = Summarise(vehicle, vehicle.ParameterValues());
  const double x = (1725 * -1.456 + 220 * -2.794) / 2165;
  const double z = (1725 * 0.832 + 440 * 0.385) / 2165;
  const auto squares = [&](auto term) {
    return 1725 * term(-1.456 - x, 0.832 - z) + 220 * term(-x, 0.385 - z) + 220 * term(-2.794 - x, 0.385 - z);
  };
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  inertia(0, 0) = 650 + 2 * 75 + squares([](double, double c) { return c * c; });
  inertia(1, 1) = 2700 + squares([](double a, double c) { return a * a + c * c; });
  inertia(2, 2) = 2700 + 2 * 75 + squares([](double a, double) { return a * a; });
  inertia(0, 2) = inertia(2, 0) = -squares([](double a, double c) { return a * c; });
  EXPECT_LT((summary.inertia - inertia).norm(), 1e-11);  // rounding of some 1000 kg m^2
  // What the wheels take along, 440 kg, follows from derivatives that are good to 1e-8, see ride_geometry_test.cpp.
  EXPECT_NEAR(summary.SprungMass_kg().value(), 1725, 1e-8 * 440);
  EXPECT_NEAR(summary.TyreLoad_N(), summary.Weight_N(), kForceRounding);
  EXPECT_EQ(summary.views.size(), 22u);
}

TEST(VehicleSummary, FollowsTheParameters) {
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  std::vector<double> values = vehicle.ParameterValues();
  values[0] = 300;
  EXPECT_EQ(Summarise(vehicle, values).mass_kg, 322);
}

// Statics of the side view: axles at x = 0 and -2.794 m.
TEST(VehicleSummary, SharesTheLinkageCarsWeightByItsCentreOfMass) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const VehicleSummary summary = Summarise(vehicle, vehicle.ParameterValues());
  EXPECT_EQ(summary.dof, 4);
  const double rear = summary.mass_kg * kGravity * -summary.com.x() / 2.794;
  ASSERT_EQ(summary.corner_loads.size(), 2u);
  EXPECT_NEAR(summary.corner_loads[1].load_N, rear, kForceRounding);
  EXPECT_NEAR(summary.corner_loads[0].load_N, summary.mass_kg * kGravity - rear, kForceRounding);
}

}  // namespace
}  // namespace fourpost::vehicle_summary_test
