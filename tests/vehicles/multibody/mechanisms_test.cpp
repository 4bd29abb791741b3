// Rods and balls in small mechanisms whose motion is known.
#include <cmath>
#include <complex>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/resting.h"
#include "tests/vehicles/vehicle_parts.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/loops/chart.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost::mechanisms_test {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// An axle of 100 kg that may shift and heave, on a coil, with a level Panhard rod of 1 m.
const std::string kPanhard = R"(<robot name="panhard" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="ground"/>
  <link name="carriage"/>
)" + PointMass("axle", "100") +
                             PrismaticJoint("shift", "ground", "carriage", "0 0 0.4", "0 1 0") +
                             PrismaticJoint("heave", "carriage", "axle", "0 0 0") + R"(
  <fp:frame name="body" link="ground" xyz="0 0.5 0.4"/>
  <fp:frame name="eye" link="axle" xyz="0 -0.5 0"/>
  <fp:rod name="panhard" parent="body" child="eye"/>
  <fp:frame name="top" link="ground" xyz="0 0 0.8"/>
  <fp:spring name="coil" parent="top" child="axle"><linear stiffness="20 N/mm"/></fp:spring>
</robot>
)";

/// How far the axle is from where its rod lets it be at this heave: y = 1 m - sqrt(1 m^2 - z^2).
double OffTheCircle(const Multibody& multibody) {
  const Vector3d place = multibody.LinkPose(2).translation();
  const double z = place.z() - 0.4;
  return place.y() - (1 - std::sqrt(1 - z * z));
}

TEST(PanhardRod, LeadsTheAxleOnACircle) {
  Multibody multibody(VehicleOf(kPanhard));
  Chart chart(multibody);
  ASSERT_EQ(chart.size(), 1);
  for (const double heave : {-0.2, -0.05, 0.0, 0.03, 0.1, 0.3}) {
    chart.MoveTo(VectorXd::Constant(1, heave));
    EXPECT_NEAR(std::abs(multibody.LinkPose(2).translation().z() - 0.4), std::abs(heave), 1e-10);
    EXPECT_NEAR(OffTheCircle(multibody), 0, 1e-10);
  }
}

TEST(PanhardRod, LeadsTheAxleOnACircleInMotion) {
  const Vehicle vehicle = VehicleOf(kPanhard);
  Multibody multibody = Resting(vehicle);
  Multibody pose(vehicle);
  Chart chart(pose);
  chart.MoveTo(VectorXd::Constant(1, 0.1));
  VectorXd state = multibody.RestState();
  state.head(2) << pose.LinkPose(2).translation().y(), pose.LinkPose(2).translation().z() - 0.4;
  int count = 0;
  constexpr double kAccuracy = 1e-9;
  multibody.Integrate(
      state, 0, 0.01, kAccuracy,
      [&](double, const VectorXd& y, const VectorXd&) {
        pose.SetPose(y.head(2));
        // Simbody projects onto the loop within its accuracy.
        EXPECT_NEAR(OffTheCircle(pose), 0, kAccuracy);
        ++count;
      },
      [&] { return count > 100; });
}

/// An axle in the plane x z, its two links `upper` and `lower` as texts of tags between frames of these names.
std::string FourLink(const std::string& links) {
  return R"(<robot name="four_link" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="ground"/>
  <link name="axle"><inertial><mass value="90"/>
    <inertia ixx="1" iyy="4" izz="4" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="plane" type="planar"><parent link="ground"/><child link="axle"/><origin xyz="0 0 0.35"/>
    <axis xyz="0 1 0"/></joint>
  <fp:frame name="lower_body" link="ground" xyz="-0.8 0 0.45"/>
  <fp:frame name="upper_body" link="ground" xyz="-0.6 0 0.7"/>
  <fp:frame name="lower" link="axle" xyz="-0.05 0 -0.05"/>
  <fp:frame name="upper" link="axle" xyz="-0.05 0 0.25"/>
  <fp:frame name="pivot_body" link="ground" xyz="-0.8 0 0.4" rpy="0 0.3 0"/>
  <fp:frame name="pivot" link="axle" xyz="-0.8 0 0.05"/>
  <fp:frame name="top" link="ground" xyz="0.05 0 0.8"/>
  <fp:frame name="seat" link="axle" xyz="0.1 0 0.05"/>
  <fp:spring name="coil" parent="top" child="seat"><linear stiffness="30 N/mm"/></fp:spring>
  <fp:damper name="shock" parent="top" child="seat"><linear rate="1 kN*s/m"/></fp:damper>
  <fp:tyre name="tyre" link="axle" xyz="0 0 0" radius="0.35 m" stiffness="200 kN/m" preload="3 kN"/>
  <fp:post name="post" under="tyre"/>
  <fp:sensor name="hop" type="accelerometer" link="axle" xyz="0 0 0"/>
  <fp:sensor name="surge" type="displacement" link="axle" xyz="0.1 0 0" axis="1 0 0"/>
  <fp:sensor name="pitch" type="gyro" link="axle" axis="0 1 0"/>
  )" + links +
         "</robot>\n";
}

/// Phasors of all sensors at 9 Hz, near the wheel hop.
Eigen::VectorXcd Response(const std::string& text) {
  const Vehicle vehicle = VehicleOf(text);
  const FrequencyResponse response = SolveHarmonicBalance(CondensedVehicle(vehicle).At(vehicle.ParameterValues()),
                                                          vehicle.sensors, {{9.0}, {0.001}, {1}})
                                         .response;
  Eigen::VectorXcd phasors(static_cast<Index>(response.channels.size()));
  for (Index i = 0; i < phasors.size(); ++i) phasors[i] = response.channels[static_cast<std::size_t>(i)].response[0];
  return phasors;
}

/// What yields by force / stiffness leaves an error that falls as the inverse of the stiffness, but for terms that fall
/// as its square: a thousandth of it here.
void ExpectFirstOrder(const std::string& rigid, const std::function<std::string(const std::string& stiffness)>& soft) {
  const Eigen::VectorXcd limit = Response(FourLink(rigid));
  const double at_1 = (Response(FourLink(soft("1000 MN/m"))) - limit).norm() / limit.norm();
  const double at_10 = (Response(FourLink(soft("10000 MN/m"))) - limit).norm() / limit.norm();
  EXPECT_LT(at_1, 0.01);
  EXPECT_NEAR(at_1 / at_10, 10, 0.05);
}

TEST(Rods, AreTheLimitOfStiffSprings) {
  ExpectFirstOrder(R"(<fp:rod name="lower" parent="lower_body" child="lower"/>
  <fp:rod name="upper" parent="upper_body" child="upper"/>)",
                   [](const std::string& stiffness) {
                     const auto link = [&](const std::string& name) {
                       return "<fp:spring name=\"" + name + "\" parent=\"" + name + "_body\" child=\"" + name +
                              "\"><linear stiffness=\"" + stiffness + "\"/></fp:spring>";
                     };
                     return link("lower") + link("upper");
                   });
}

TEST(Balls, AreTheLimitOfStiffBushings) {
  ExpectFirstOrder(R"(<fp:ball name="pivot" parent="pivot_body" child="pivot"/>)", [](const std::string& stiffness) {
    return R"(<fp:bushing name="pivot" parent="pivot_body" child="pivot" preload="equilibrium"><translation x=")" +
           stiffness + R"(" z=")" + stiffness + R"("/></fp:bushing>)";
  });
}

}  // namespace
}  // namespace fourpost::mechanisms_test
