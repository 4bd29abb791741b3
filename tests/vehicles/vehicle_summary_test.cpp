#include "vehicles/vehicle_summary.h"

#include <gtest/gtest.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/gravity.h"

namespace fourpost {
namespace {

TEST(VehicleSummary, HasTheQuarterCarsMassesAndLoad) {
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  const VehicleSummary summary = Summarise(vehicle, vehicle.ParameterValues());
  EXPECT_EQ(summary.dof, 2);
  EXPECT_EQ(summary.mass_kg, 222);
  // 200 kg at 0.7 m, 22 kg at 0.3 m.
  EXPECT_LT((summary.com - Eigen::Vector3d(0, 0, (200 * 0.7 + 22 * 0.3) / 222)).norm(), 1e-15);  // rounding
  ASSERT_EQ(summary.corner_loads.size(), 1u);
  EXPECT_EQ(summary.corner_loads[0].tyre, "tyre");
  EXPECT_NEAR(summary.corner_loads[0].load_N, 222 * kGravity, 1e-9);  // rounding of 2 kN
  EXPECT_EQ(summary.modes.size(), 2u);
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
  EXPECT_NEAR(summary.corner_loads[1].load_N, rear, 1e-6);  // rounding of 20 kN, ends printed to a millimetre
  EXPECT_NEAR(summary.corner_loads[0].load_N, summary.mass_kg * kGravity - rear, 1e-6);
}

}  // namespace
}  // namespace fourpost
