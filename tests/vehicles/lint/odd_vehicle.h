#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "tests/findings.h"
#include "tests/vehicles/lint_all.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/lint/vehicle_lint.h"

namespace fourpost {

/// An axle's share of a car, without a fault and without anything odd: a body that heaves and rolls on two wheels.
inline const std::string kAxle = R"(<robot name="axle" xmlns:fp="urn:fourpost:vehicle:1">
<link name="ground"/>
<link name="heave"/>
<link name="body">
  <inertial>
    <origin xyz="0 0 0"/><mass value="500"/>
    <inertia ixx="100" iyy="100" izz="100" ixy="0" ixz="0" iyz="0"/>
  </inertial>
</link>
<link name="wheel_left">
  <inertial><mass value="40"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
</link>
<link name="wheel_right">
  <inertial><mass value="40"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
</link>
<joint name="heave" type="prismatic">
  <parent link="ground"/><child link="heave"/><origin xyz="0 0 0.8"/><axis xyz="0 0 1"/>
  <limit effort="0" velocity="0"/>
</joint>
<joint name="roll" type="continuous"><parent link="heave"/><child link="body"/><axis xyz="1 0 0"/></joint>
<joint name="travel_left" type="prismatic">
  <parent link="ground"/><child link="wheel_left"/><origin xyz="0 0.7 0.3"/><axis xyz="0 0 1"/>
  <limit effort="0" velocity="0"/>
</joint>
<joint name="travel_right" type="prismatic">
  <parent link="ground"/><child link="wheel_right"/><origin xyz="0 -0.7 0.3"/><axis xyz="0 0 1"/>
  <limit effort="0" velocity="0"/>
</joint>
<fp:frame name="top_left" link="body" xyz="0 0.7 0"/>
<fp:frame name="top_right" link="body" xyz="0 -0.7 0"/>
<fp:spring name="coil_left" parent="top_left" child="wheel_left"><linear stiffness="30 kN/m"/></fp:spring>
<fp:spring name="coil_right" parent="top_right" child="wheel_right"><linear stiffness="30 kN/m"/></fp:spring>
<fp:damper name="damper_left" parent="top_left" child="wheel_left">
  <bilinear bump="1000 N*s/m" rebound="2000 N*s/m"/>
</fp:damper>
<fp:damper name="damper_right" parent="body" child="wheel_right">
  <bilinear bump="999 N*s/m" rebound="2000 N*s/m"/>
</fp:damper>
<fp:antiroll name="bar" stiffness="5 kN/m">
  <left parent="body" child="wheel_left"/><right parent="body" child="wheel_right"/>
</fp:antiroll>
<fp:tyre name="tyre_left" link="wheel_left" xyz="0 0 0" radius="0.3 m" stiffness="200 kN/m"/>
<fp:tyre name="tyre_right" link="wheel_right" xyz="0 0 0" radius="0.3 m" stiffness="200 kN/m"/>
<fp:post name="left" under="tyre_left"/>
<fp:post name="right" under="tyre_right"/>
<fp:sensor name="a_body" type="accelerometer" link="body" xyz="0 0 0.2"/>
</robot>
)";

/// A rigid body on its tyres.
inline std::string Kart(const std::string& tyre) {
  std::string text = R"(<robot name="kart" xmlns:fp="urn:fourpost:vehicle:1">
<link name="ground"/>
<link name="body">
  <inertial><mass value="200"/><inertia ixx="30" iyy="60" izz="80" ixy="0" ixz="0" iyz="0"/></inertial>
</link>
<joint name="body" type="floating"><parent link="ground"/><child link="body"/><origin xyz="0 0 0.2"/></joint>
<fp:sensor name="a_body" type="accelerometer" link="body" xyz="0 0 0"/>
)";
  for (const auto& [name, xyz] : {std::pair("FL", "0.5 0.5 0"), std::pair("FR", "0.5 -0.5 0"),
                                  std::pair("RL", "-0.5 0.5 0"), std::pair("RR", "-0.5 -0.5 0")})
    text += std::string("<fp:tyre name=\"") + name + "\" link=\"body\" xyz=\"" + xyz + "\" stiffness=\"100 kN/m\" " +
            tyre + "/><fp:post name=\"" + name + "\" under=\"" + name + "\"/>\n";
  return text + "</robot>\n";
}

/// Looks at descriptions of one side each of whose texts a test changes.
class VehicleLintTest : public VehicleFileTest {
 protected:
  /// Takes the findings about a description for those that the test has to expect.
  void Look(const std::string& text) {
    const std::optional<Vehicle> vehicle = Read(text);
    ASSERT_TRUE(vehicle.has_value()) << diagnostics_.Format();
    EXPECT_EQ(diagnostics_.Format(), "");
    diagnostics_ = Lint(*vehicle);
  }

  /// Takes one finding in the line of `at`.
  void ExpectWarning(const std::string& text, const std::string& at, const Finding& kind,
                     const std::vector<std::string>& words = {}) {
    Expect(LineOf(text, at), kind, words);
  }
};

/// Of a vehicle, all of them warnings, each in the line expected.
inline std::vector<Diagnostic> Findings(const Vehicle& vehicle, int line) {
  const Diagnostics findings = Lint(vehicle);
  for (const Diagnostic& item : findings.items()) {
    EXPECT_EQ(item.severity, Severity::kWarning);
    EXPECT_EQ(item.place.file, vehicle.file);
    EXPECT_EQ(item.place.line, line) << item.message;
  }
  return findings.items();
}

inline Vehicle ShippedQuarterCar() { return ShippedVehicle("quarter_car"); }

/// With a tyre that damps whatever else does not.
inline Vehicle DampedQuarterCar() {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.tyres[0].damping = {.value = 500};
  return vehicle;
}

}  // namespace fourpost
