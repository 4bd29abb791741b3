#include "vehicles/description/chassis.h"

#include <gtest/gtest.h>

namespace fourpost::chassis_test {
namespace {

TEST(Chassis, IsTheHeaviestWithoutATyre) {
  EXPECT_EQ(ChassisOf({}), -1);
  const std::vector<TyreCarrier> car = {{0, {}}, {220, {0, 0}}, {1725, {}}, {2000, {-2.8, -2.8}}, {90, {}}};
  EXPECT_EQ(ChassisOf(car), 2);
  const std::vector<TyreCarrier> rig = {{0, {}}, {22, {0}}};
  EXPECT_EQ(ChassisOf(rig), -1);
}

TEST(Chassis, IsTheFrameThatLocatesTheTyresOfAllAxles) {
  const std::vector<TyreCarrier> kart = {{0, {}}, {200, {0.5, 0.5, -0.5, -0.5}}, {20, {}}};
  EXPECT_EQ(ChassisOf(kart), 1);
  const std::vector<TyreCarrier> loaded = {{200, {0.5, 0.5, -0.5, -0.5}}, {600, {}}};
  EXPECT_EQ(ChassisOf(loaded), 0);
}

TEST(Chassis, IsNoWalkingBeamOfATandemAxle) {
  const std::vector<TyreCarrier> lorry = {{400, {4, 4}}, {5000, {}}, {80, {0, -1.2}}, {80, {0, -1.2}}};
  EXPECT_EQ(ChassisOf(lorry), 1);
  // A tractor on its tyres before a trailer on one axle.
  const std::vector<TyreCarrier> artic = {{90, {}}, {7000, {4, 4, 0, 0}}, {6000, {-8, -8}}};
  EXPECT_EQ(ChassisOf(artic), 1);
}

TEST(Chassis, CountsAxlesByTheirStations) {
  EXPECT_EQ(AxleCount({}), 0);
  EXPECT_EQ(AxleCount({0.02, -2.8, 0, -2.81}), 2);
  // 0.3 m from the first of the axle.
  EXPECT_EQ(AxleCount({0, -0.2, -0.4}), 2);
}

}  // namespace
}  // namespace fourpost::chassis_test
