#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/vehicles/vehicle_parts.h"

namespace fourpost {

inline const std::string kMirror = R"(<fp:mirror from="_left" to="_right"/>)";

/// Lines of one corner of a double wishbone axle, and of the other: links turned by fixed joints, skewed axes, loops.
inline const std::vector<std::pair<std::string, std::string>>& Corners() {
  static const std::string mesh = std::string(FOURPOST_SOURCE_DIR) + "/meshes/wheel.stl";
  static const std::vector<std::pair<std::string, std::string>> corners = {
      {R"(<link name="lower_left"><inertial><origin xyz="0.01 0.15 0.02" rpy="0.1 0.2 0.3"/><mass value="3"/>)"
       R"(<inertia ixx="0.02" iyy="0.03" izz="0.04" ixy="0.001" ixz="0.002" iyz="-0.003"/></inertial></link>)",
       R"(<link name="lower_right"><inertial><origin xyz="0.01 -0.15 0.02" rpy="-0.1 0.2 -0.3"/><mass value="3"/>)"
       R"(<inertia ixx="0.02" iyy="0.03" izz="0.04" ixy="-0.001" ixz="0.002" iyz="0.003"/></inertial></link>)"},
      {R"(<link name="upper_left"><inertial><origin xyz="0 0.13 0"/><mass value="2"/>)"
       R"(<inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>)",
       R"(<link name="upper_right"><inertial><origin xyz="0 -0.13 0"/><mass value="2"/>)"
       R"(<inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>)"},
      {R"(<link name="knuckle_left"><inertial><origin xyz="0 0.03 0"/><mass value="12"/>)"
       R"(<inertia ixx="0.1" iyy="0.12" izz="0.13" ixy="0.01" ixz="0.02" iyz="0.03"/></inertial></link>)",
       R"(<link name="knuckle_right"><inertial><origin xyz="0 -0.03 0"/><mass value="12"/>)"
       R"(<inertia ixx="0.1" iyy="0.12" izz="0.13" ixy="-0.01" ixz="0.02" iyz="-0.03"/></inertial></link>)"},
      {R"(<link name="hub_left"><inertial><origin xyz="0.01 0.02 0.03"/><mass value="20"/>)"
       R"(<inertia ixx="0.5" iyy="0.9" izz="0.5" ixy="0" ixz="0" iyz="0"/></inertial>)"
       R"(<visual><origin xyz="0 0.01 0" rpy="0.3 0 0"/><geometry><mesh filename=")" +
           mesh + R"(" scale="0.6 0.2 0.6"/></geometry></visual></link>)",
       R"(<link name="hub_right"><inertial><origin xyz="0.01 -0.02 0.03"/><mass value="20"/>)"
       R"(<inertia ixx="0.5" iyy="0.9" izz="0.5" ixy="0" ixz="0" iyz="0"/></inertial>)"
       R"(<visual><origin xyz="0 -0.01 0" rpy="-0.3 0 0"/><geometry><mesh filename=")" +
           mesh + R"(" scale="0.6 -0.2 0.6"/></geometry></visual></link>)"},
      {R"(<joint name="lower_left" type="continuous"><parent link="body"/><child link="lower_left"/>)"
       R"(<origin xyz="0.05 0.35 -0.2"/><axis xyz="1 0.02 -0.05"/></joint>)",
       R"(<joint name="lower_right" type="continuous"><parent link="body"/><child link="lower_right"/>)"
       R"(<origin xyz="0.05 -0.35 -0.2"/><axis xyz="-1 0.02 0.05"/></joint>)"},
      // URDF's axis, where none is given, is x.
      {R"(<joint name="upper_left" type="continuous"><parent link="body"/><child link="upper_left"/>)"
       R"(<origin xyz="0 0.4 0.1"/></joint>)",
       R"(<joint name="upper_right" type="continuous"><parent link="body"/><child link="upper_right"/>)"
       R"(<origin xyz="0 -0.4 0.1"/><axis xyz="-1 0 0"/></joint>)"},
      {R"(<joint name="knuckle_left" type="floating"><parent link="body"/><child link="knuckle_left"/>)"
       R"(<origin xyz="0 0.72 -0.05"/></joint>)",
       R"(<joint name="knuckle_right" type="floating"><parent link="body"/><child link="knuckle_right"/>)"
       R"(<origin xyz="0 -0.72 -0.05"/></joint>)"},
      {R"(<joint name="hub_left" type="fixed"><parent link="knuckle_left"/><child link="hub_left"/>)"
       R"(<origin xyz="0 0.05 0" rpy="0.1 0.2 0.3"/></joint>)",
       R"(<joint name="hub_right" type="fixed"><parent link="knuckle_right"/><child link="hub_right"/>)"
       R"(<origin xyz="0 -0.05 0" rpy="-0.1 0.2 -0.3"/></joint>)"},
      {R"(<fp:frame name="lower_ball_left" link="lower_left" xyz="0 0.35 0"/>)",
       R"(<fp:frame name="lower_ball_right" link="lower_right" xyz="0 -0.35 0"/>)"},
      {R"(<frame name="lower_pin_left" link="knuckle_left" xyz="0.05 -0.02 -0.15"/>)",
       R"(<frame name="lower_pin_right" link="knuckle_right" xyz="0.05 0.02 -0.15"/>)"},
      {R"(<fp:frame name="upper_ball_left" link="upper_left" xyz="0 0.26 0"/>)",
       R"(<fp:frame name="upper_ball_right" link="upper_right" xyz="0 -0.26 0"/>)"},
      {R"(<fp:frame name="upper_pin_left" link="knuckle_left" xyz="0 -0.06 0.15"/>)",
       R"(<fp:frame name="upper_pin_right" link="knuckle_right" xyz="0 0.06 0.15"/>)"},
      {R"(<fp:frame name="toe_in_left" link="body" xyz="-0.12 0.38 -0.15"/>)",
       R"(<fp:frame name="toe_in_right" link="body" xyz="-0.12 -0.38 -0.15"/>)"},
      {R"(<fp:frame name="toe_out_left" link="knuckle_left" xyz="-0.12 -0.02 -0.09"/>)",
       R"(<fp:frame name="toe_out_right" link="knuckle_right" xyz="-0.12 0.02 -0.09"/>)"},
      {R"(<fp:frame name="top_left" link="body" xyz="0.02 0.5 0.3"/>)",
       R"(<fp:frame name="top_right" link="body" xyz="0.02 -0.5 0.3"/>)"},
      {R"(<fp:frame name="seat_left" link="lower_left" xyz="0 0.2 0.02"/>)",
       R"(<fp:frame name="seat_right" link="lower_right" xyz="0 -0.2 0.02"/>)"},
      {R"(<fp:ball name="lower_left" parent="lower_ball_left" child="lower_pin_left"/>)",
       R"(<fp:ball name="lower_right" parent="lower_ball_right" child="lower_pin_right"/>)"},
      {R"(<fp:ball name="upper_left" parent="upper_ball_left" child="upper_pin_left"/>)",
       R"(<fp:ball name="upper_right" parent="upper_ball_right" child="upper_pin_right"/>)"},
      {R"(<fp:rod name="toe_left" parent="toe_in_left" child="toe_out_left"/>)",
       R"(<fp:rod name="toe_right" parent="toe_in_right" child="toe_out_right"/>)"},
      {R"(<fp:spring name="coil_left" parent="top_left" child="seat_left"><linear stiffness="$k"/></fp:spring>)",
       R"(<fp:spring name="coil_right" parent="top_right" child="seat_right"><linear stiffness="$k"/></fp:spring>)"},
      {R"(<fp:damper name="shock_left" parent="top_left" child="seat_left" axis="0 0.2 1">)"
       R"(<bilinear bump="1 kN*s/m" rebound="2 kN*s/m"/></fp:damper>)",
       R"(<fp:damper name="shock_right" parent="top_right" child="seat_right" axis="0 -0.2 1">)"
       R"(<bilinear bump="1 kN*s/m" rebound="2 kN*s/m"/></fp:damper>)"},
      {R"(<fp:frame name="mount_in_left" link="body" xyz="0.1 0.35 -0.2" rpy="0.3 0.2 0.1"/>)",
       R"(<fp:frame name="mount_in_right" link="body" xyz="0.1 -0.35 -0.2" rpy="-0.3 0.2 -0.1"/>)"},
      {R"(<fp:frame name="mount_out_left" link="lower_left" xyz="0.05 0 0"/>)",
       R"(<fp:frame name="mount_out_right" link="lower_right" xyz="0.05 0 0"/>)"},
      {R"(<fp:bushing name="mount_left" parent="mount_in_left" child="mount_out_left">)"
       R"(<translation x="1 kN/m" y="2 kN/m" z="5 kN/m"/><rotation x="1 kN*m/rad" y="3 kN*m/rad" z="9 kN*m/rad"/>)"
       R"(</fp:bushing>)",
       R"(<fp:bushing name="mount_right" parent="mount_in_right" child="mount_out_right">)"
       R"(<translation x="1 kN/m" y="2 kN/m" z="5 kN/m"/><rotation x="1 kN*m/rad" y="3 kN*m/rad" z="9 kN*m/rad"/>)"
       R"(</fp:bushing>)"},
      {R"(<fp:tyre name="tyre_left" link="hub_left" xyz="0 0.01 0" stiffness="200 kN/m" damping="100 N*s/m"/>)",
       R"(<fp:tyre name="tyre_right" link="hub_right" xyz="0 -0.01 0" stiffness="200 kN/m" damping="100 N*s/m"/>)"},
      {R"(<fp:post name="post_left" under="tyre_left"/>)", R"(<fp:post name="post_right" under="tyre_right"/>)"},
      {R"(<fp:sensor name="a_left" type="accelerometer" link="hub_left" xyz="0 0 0.3" axis="0 1 0"/>)",
       R"(<fp:sensor name="a_right" type="accelerometer" link="hub_right" xyz="0 0 0.3" axis="0 -1 0"/>)"},
      {R"(<fp:sensor name="z_left" type="displacement" link="knuckle_left" xyz="0 0.1 0"/>)",
       R"(<fp:sensor name="z_right" type="displacement" link="knuckle_right" xyz="0 -0.1 0"/>)"},
      {R"(<fp:sensor name="s_left" type="strut" parent="top_left" child="seat_left" axis="0 0.2 1"/>)",
       R"(<fp:sensor name="s_right" type="strut" parent="top_right" child="seat_right" axis="0 -0.2 1"/>)"},
      {R"(<fp:sensor name="F_left" type="load_cell" tyre="tyre_left"/>)",
       R"(<fp:sensor name="F_right" type="load_cell" tyre="tyre_right"/>)"}};
  return corners;
}

inline constexpr unsigned kLeft = 1;
inline constexpr unsigned kRight = 2;

/// A bind to a number of each side that is written out.
inline std::string Binds(unsigned sides, const std::string& link, const std::string& number,
                         const std::string& right_sign) {
  std::string text;
  const auto bind = [&](const std::string& side, const std::string& sign) {
    text += "<fp:bind to=\"link[" + link + side + "]/" + number + "\" factor=\"" + sign + "2\"/>\n";
  };
  if ((sides & kLeft) != 0) bind("_left", "");
  if ((sides & kRight) != 0) bind("_right", right_sign);
  return text;
}

/// An axle whose body moves up and rolls, with these corners written out.
inline std::string Axle(unsigned sides, const std::string& more = "") {
  std::string text = R"(<robot name="axle" xmlns:fp="urn:fourpost:vehicle:1"><link name="ground"/><link name="heave"/>
<link name="body"><inertial><mass value="600"/><inertia ixx="150" iyy="300" izz="300" ixy="0" ixz="0" iyz="0"/></inertial></link>
)" + PrismaticJoint("heave", "ground", "heave", "0 0 0.5") +
                     R"(<joint name="roll" type="continuous"><parent link="heave"/><child link="body"/></joint>
<fp:parameter name="k" value="80 N/mm" lower="40 N/mm" upper="90 N/mm" precision="1 N/mm" source="test"/>
<fp:parameter name="m" value="10 kg" lower="5 kg" upper="15 kg" precision="1 kg" source="test">)" +
                     Binds(sides, "hub", "mass", "") +
                     R"(</fp:parameter>
<fp:parameter name="I" value="0.005 kg*m^2" source="test">)" +
                     Binds(sides, "knuckle", "inertia/ixy", "-") +
                     R"(</fp:parameter>
<fp:parameter name="y" value="15 mm" source="test">)" +
                     Binds(sides, "knuckle", "com/y", "-") +
                     R"(</fp:parameter>
<fp:sensor name="roll" type="displacement" link="body" xyz="0 0.5 0"/>
<fp:sensor name="heave" type="displacement" link="body" xyz="0 0 0"/>
)";
  for (const auto& [left, right] : Corners()) {
    if ((sides & kLeft) != 0) text += left + "\n";
    if ((sides & kRight) != 0) text += right + "\n";
  }
  return text + more + "</robot>\n";
}

}  // namespace fourpost
