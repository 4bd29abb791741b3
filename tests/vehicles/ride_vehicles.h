#pragma once

#include <string>

#include "tests/vehicles/vehicle_parts.h"

namespace fourpost {

// Vehicles whose ride geometry is worked out by hand.

/// One corner: the chassis slides upright, a trailing arm of 0.5 m turns on it, the wheel at the arm's end on level
/// with its pivot; coil and damper stand upright at 0.25 m and 0.4 m from the pivot.
inline const std::string kTrailingArm =
    R"(<?xml version="1.0"?>
<robot name="trailing_arm" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="ground"/>
)" + PointMass("chassis", "300") +
    R"(  <link name="arm">
    <inertial>
      <origin xyz="-0.4 0 0"/><mass value="30"/><inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/>
    </inertial>
  </link>
)" + PrismaticJoint("travel", "ground", "chassis", "0.5 0 0.3") +
    R"(  <joint name="pivot" type="continuous"><parent link="chassis"/><child link="arm"/><axis xyz="0 1 0"/></joint>
  <fp:frame name="coil_top" link="chassis" xyz="-0.25 0 0.3"/>
  <fp:frame name="coil_foot" link="arm" xyz="-0.25 0 0"/>
  <fp:frame name="damper_top" link="chassis" xyz="-0.4 0 0.35"/>
  <fp:frame name="damper_foot" link="arm" xyz="-0.4 0 0"/>
  <fp:spring name="coil" parent="coil_top" child="coil_foot"><linear stiffness="80 N/mm"/></fp:spring>
  <fp:damper name="damper" parent="damper_top" child="damper_foot"><linear rate="2 kN*s/m"/></fp:damper>
  <fp:tyre name="tyre" link="arm" xyz="-0.5 0 0" stiffness="180 N/mm"/>
  <fp:post name="post" under="tyre"/>
  <fp:sensor name="a_chassis" type="accelerometer" link="chassis" xyz="0 0 0"/>
</robot>
)";

/// The same with sensors of what its arm's turning changes most: fore-aft acceleration, coil and tyre.
inline std::string SensedTrailingArm() {
  const std::string end = "</robot>";
  std::string text = kTrailingArm;
  return text.replace(text.rfind(end), end.size(), R"(
  <fp:sensor name="a_fore" type="accelerometer" link="arm" xyz="-0.5 0 0" axis="1 0 0"/>
  <fp:sensor name="s_coil" type="strut" parent="coil_top" child="coil_foot"/>
  <fp:sensor name="F_tyre" type="load_cell" tyre="tyre"/>
</robot>)");
}

/// A car in space on four trailing arms, alike on both sides, with an anti-roll bar in front.
inline const std::string kIndependentCar = R"(<?xml version="1.0"?>
<robot name="independent" xmlns:fp="urn:fourpost:vehicle:1">
  <fp:mirror from="_left" to="_right"/>
  <link name="ground"/>
  <link name="body">
    <inertial><mass value="1200"/><inertia ixx="400" ixy="0" ixz="-30" iyy="1600" iyz="0" izz="1700"/></inertial>
  </link>
  <link name="front_left">
    <inertial>
      <origin xyz="-0.4 0 0"/><mass value="40"/><inertia ixx="0.5" ixy="0" ixz="0" iyy="1" iyz="0" izz="0.6"/>
    </inertial>
  </link>
  <link name="rear_left">
    <inertial>
      <origin xyz="-0.4 0 0"/><mass value="45"/><inertia ixx="0.5" ixy="0" ixz="0" iyy="1" iyz="0" izz="0.6"/>
    </inertial>
  </link>
  <joint name="body" type="floating"><parent link="ground"/><child link="body"/><origin xyz="-1.2 0 0.55"/></joint>
  <joint name="front_left" type="continuous">
    <parent link="body"/><child link="front_left"/><origin xyz="1.6 0.7 -0.25"/><axis xyz="0 1 0"/>
  </joint>
  <joint name="rear_left" type="continuous">
    <parent link="body"/><child link="rear_left"/><origin xyz="-1.0 0.7 -0.25"/><axis xyz="0 1 0"/>
  </joint>
  <fp:parameter name="k_front" value="30 N/mm" lower="20 N/mm" upper="40 N/mm" precision="0.1 N/mm" source="test"/>
  <fp:parameter name="I_roll" value="400 kg*m^2" lower="300 kg*m^2" upper="500 kg*m^2" precision="1 kg*m^2"
                source="test"><fp:bind to="link[body]/inertia/ixx"/></fp:parameter>
  <fp:frame name="front_top_left" link="body" xyz="1.2 0.7 0.05"/>
  <fp:frame name="front_seat_left" link="front_left" xyz="-0.4 0 0"/>
  <fp:frame name="rear_top_left" link="body" xyz="-1.4 0.7 0.05"/>
  <fp:frame name="rear_seat_left" link="rear_left" xyz="-0.4 0 0"/>
  <fp:spring name="front_left" parent="front_top_left" child="front_seat_left"><linear stiffness="$k_front"/></fp:spring>
  <fp:spring name="rear_left" parent="rear_top_left" child="rear_seat_left"><linear stiffness="35 N/mm"/></fp:spring>
  <fp:damper name="front_left" parent="front_top_left" child="front_seat_left">
    <bilinear bump="1 kN*s/m" rebound="2 kN*s/m"/>
  </fp:damper>
  <fp:damper name="rear_left" parent="rear_top_left" child="rear_seat_left">
    <bilinear bump="1 kN*s/m" rebound="2 kN*s/m"/>
  </fp:damper>
  <fp:antiroll name="bar" stiffness="10 N/mm">
    <left parent="front_top_left" child="front_seat_left"/><right parent="front_top_right" child="front_seat_right"/>
  </fp:antiroll>
  <fp:tyre name="front_left" link="front_left" xyz="-0.4 0 0" stiffness="200 N/mm" lateral="100 N/mm"
           longitudinal="100 N/mm"/>
  <fp:tyre name="rear_left" link="rear_left" xyz="-0.4 0 0" stiffness="210 N/mm" lateral="100 N/mm"
           longitudinal="100 N/mm"/>
  <fp:post name="front_left" under="front_left"/>
  <fp:post name="rear_left" under="rear_left"/>
  <fp:sensor name="a_front_left" type="accelerometer" link="body" xyz="1.2 0.7 0"/>
  <fp:sensor name="a_rear_left" type="accelerometer" link="body" xyz="-1.4 0.7 0"/>
  <fp:sensor name="a_hub_front_left" type="accelerometer" link="front_left" xyz="-0.4 0 0"/>
  <fp:sensor name="roll_rate" type="gyro" link="body" axis="1 0 0"/>
</robot>
)";

/// What holds an axle to the frame, and what carries it: bushings `arm` ahead of the axle, coils and dampers above it.
inline std::string BeamAxle(const std::string& axle, double x, double arm) {
  const auto point = [](double px, const std::string& side, double py, double pz) {
    return std::to_string(px) + " " + (side == "_L" ? "" : "-") + std::to_string(py) + " " + std::to_string(pz);
  };
  std::string text;
  for (const std::string side : {"_L", "_R"}) {
    const std::string name = axle + side;
    const auto frame = [&](const std::string& what, const std::string& link, const std::string& xyz) {
      return "<fp:frame name='" + name + what + "' link='" + link + "' xyz='" + xyz + "'/>\n";
    };
    const auto ends = [&](const std::string& parent, const std::string& child) {
      return " name='" + name + "' parent='" + name + parent + "' child='" + name + child + "'>";
    };
    text += frame("_bush", axle + "_axle", point(arm, side, 0.45, 0)) +
            frame("_mount", "frame", point(x + arm, side, 0.45, -0.4)) +
            frame("_foot", axle + "_axle", point(0, side, 0.45, 0)) + frame("_top", "frame", point(x, side, 0.45, 0)) +
            "<fp:bushing" + ends("_mount", "_bush") + "<translation x='3 MN/m' y='2 MN/m' z='3 MN/m'/>" +
            "<rotation x='500 N*m/rad' y='200 N*m/rad' z='500 N*m/rad'/><loss factor='0.1' frequency='10 Hz'/>" +
            "</fp:bushing>\n<fp:spring" + ends("_top", "_foot") + "<linear stiffness='40 N/mm'/></fp:spring>\n" +
            "<fp:damper" + ends("_top", "_foot") + "<linear rate='2.5 kN*s/m'/></fp:damper>\n<fp:tyre name='" + name +
            "' link='" + axle + "_axle' xyz='" + point(0, side, 0.75, 0) +
            "' radius='0.4 m' stiffness='350 N/mm' lateral='150 N/mm' longitudinal='150 N/mm'/>\n";
  }
  return text;
}

/// A car in space whose beam axles hang on bushings, with an engine on a mount.
inline std::string BeamAxleCar() {
  const std::string car =
      R"(<?xml version="1.0"?>
<robot name="beam_axles" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="ground"/>
  <link name="frame">
    <inertial><mass value="1700"/><inertia ixx="650" ixy="0" ixz="0" iyy="2700" iyz="0" izz="2800"/></inertial>
  </link>
  <link name="engine">
    <inertial><mass value="250"/><inertia ixx="10" ixy="0" ixz="0" iyy="20" iyz="0" izz="20"/></inertial>
  </link>
  <link name="front_axle">
    <inertial><mass value="220"/><inertia ixx="75" ixy="0" ixz="0" iyy="8" iyz="0" izz="75"/></inertial>
  </link>
  <link name="rear_axle">
    <inertial><mass value="220"/><inertia ixx="75" ixy="0" ixz="0" iyy="8" iyz="0" izz="75"/></inertial>
  </link>
  <joint name="frame" type="floating"><parent link="ground"/><child link="frame"/><origin xyz="-1.4 0 0.8"/></joint>
)" + PrismaticJoint("engine", "frame", "engine", "1.2 0 0") +
      R"(
  <joint name="front" type="floating"><parent link="ground"/><child link="front_axle"/><origin xyz="0 0 0.4"/></joint>
  <joint name="rear" type="floating"><parent link="ground"/><child link="rear_axle"/><origin xyz="-2.8 0 0.4"/></joint>
  <fp:spring name="mount" parent="frame" child="engine" axis="0 0 1"><linear stiffness="400 N/mm"/></fp:spring>
  <fp:damper name="mount" parent="frame" child="engine" axis="0 0 1"><linear rate="500 N*s/m"/></fp:damper>
)";
  return car + BeamAxle("front", 1.4, -0.9) + BeamAxle("rear", -1.4, 0.9) + "</robot>\n";
}

}  // namespace fourpost
