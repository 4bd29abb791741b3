#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "analysis/text/diagnostics.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {

/// A car with every element in it: a beam axle on rods in front, a trailing arm in the tree with a wheel welded to it
/// and one on a hinge behind, an engine on mounts that carry it, an exhaust on a ball. No line is vertical but where it
/// must be; every number of an element is a parameter.
inline const std::string kElementCar = R"(<?xml version="1.0"?>
<robot name="element_car" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="ground"/>
  <link name="chassis"><inertial><origin xyz="-0.1 0.02 0.05"/><mass value="900"/>
    <inertia ixx="300" iyy="1200" izz="1300" ixy="5" ixz="-20" iyz="3"/></inertial></link>
  <link name="axle"><inertial><origin xyz="0.01 0 0.01"/><mass value="90"/>
    <inertia ixx="18" iyy="3" izz="18" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="arm"><inertial><origin xyz="-0.2 0.05 -0.03"/><mass value="12"/>
    <inertia ixx="0.1" iyy="0.4" izz="0.4" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="hub"><inertial><mass value="25"/>
    <inertia ixx="0.6" iyy="0.9" izz="0.6" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="hinged"><inertial><origin xyz="-0.35 -0.08 -0.04"/><mass value="37"/>
    <inertia ixx="0.8" iyy="1.6" izz="1.6" ixy="0" ixz="0.1" iyz="0"/></inertial></link>
  <link name="engine"><inertial><origin xyz="0.02 0.01 0.1"/><mass value="180"/>
    <inertia ixx="8" iyy="14" izz="13" ixy="0.2" ixz="-0.5" iyz="0.1"/></inertial></link>
  <link name="exhaust"><inertial><origin xyz="-0.5 0 0"/><mass value="15"/>
    <inertia ixx="0.1" iyy="1.3" izz="1.3" ixy="0" ixz="0" iyz="0"/></inertial></link>

  <joint name="j_chassis" type="floating"><parent link="ground"/><child link="chassis"/><origin xyz="0 0 0.6"/></joint>
  <joint name="j_axle" type="floating"><parent link="ground"/><child link="axle"/><origin xyz="1.2 0 0.35"/></joint>
  <joint name="j_arm" type="continuous"><parent link="chassis"/><child link="arm"/><origin xyz="-0.9 0.6 -0.2"/>
    <axis xyz="-0.2 1 -0.05"/></joint>
  <joint name="j_hub" type="floating"><parent link="ground"/><child link="hub"/><origin xyz="-1.3 0.7 0.35"/></joint>
  <joint name="j_hinged" type="floating"><parent link="ground"/><child link="hinged"/>
    <origin xyz="-0.9 -0.6 0.4"/></joint>
  <joint name="j_engine" type="floating"><parent link="chassis"/><child link="engine"/>
    <origin xyz="0.9 0 0.05"/></joint>
  <joint name="j_exhaust" type="floating"><parent link="chassis"/><child link="exhaust"/>
    <origin xyz="0.3 0.2 -0.25"/></joint>

  <fp:parameter name="m_chassis" value="900 kg" source="test"><fp:bind to="link[chassis]/mass"/></fp:parameter>
  <fp:parameter name="x_chassis" value="-0.1 m" source="test"><fp:bind to="link[chassis]/com/x"/></fp:parameter>
  <fp:parameter name="y_chassis" value="0.02 m" source="test"><fp:bind to="link[chassis]/com/y"/></fp:parameter>
  <fp:parameter name="z_chassis" value="0.05 m" source="test"><fp:bind to="link[chassis]/com/z"/></fp:parameter>
  <fp:parameter name="I_chassis" value="300 kg*m^2" source="test">
    <fp:bind to="link[chassis]/inertia/ixx"/><fp:bind to="link[chassis]/inertia/iyy" factor="4"/></fp:parameter>
  <fp:parameter name="I_product" value="-20 kg*m^2" source="test">
    <fp:bind to="link[chassis]/inertia/ixz"/></fp:parameter>
  <fp:parameter name="m_axle" value="90 kg" source="test"><fp:bind to="link[axle]/mass"/></fp:parameter>

  <fp:frame name="radius_left" link="chassis" xyz="0.4 0.4 -0.2"/>
  <fp:frame name="radius_right" link="chassis" xyz="0.4 -0.4 -0.2"/>
  <fp:frame name="arm_left" link="axle" xyz="-0.05 0.4 -0.02"/>
  <fp:frame name="arm_right" link="axle" xyz="-0.05 -0.4 -0.02"/>
  <fp:frame name="panhard_chassis" link="chassis" xyz="1.3 0.5 -0.15"/>
  <fp:frame name="panhard_axle" link="axle" xyz="0.1 -0.5 0.05"/>
  <fp:rod name="radius_left" parent="radius_left" child="arm_left"/>
  <fp:rod name="radius_right" parent="radius_right" child="arm_right"/>
  <fp:rod name="panhard" parent="panhard_chassis" child="panhard_axle"/>
  <fp:frame name="arm_end" link="arm" xyz="-0.4 0.1 -0.05"/>
  <fp:weld name="wheel" parent="arm_end" child="hub"/>
  <fp:frame name="pivot" link="chassis" xyz="-0.9 -0.6 -0.2"/>
  <fp:hinge name="pivot" parent="pivot" child="hinged" axis="0.2 1 0.05"/>
  <fp:frame name="manifold" link="chassis" xyz="0.3 0.2 -0.25"/>
  <fp:ball name="manifold" parent="manifold" child="exhaust"/>

  <fp:frame name="top_fl" link="chassis" xyz="1.2 0.45 0.1"/>
  <fp:frame name="top_fr" link="chassis" xyz="1.2 -0.45 0.1"/>
  <fp:frame name="seat_fl" link="axle" xyz="0 0.5 0.05"/>
  <fp:frame name="seat_fr" link="axle" xyz="0 -0.5 0.05"/>
  <fp:parameter name="k_fl" value="30 N/mm" source="test"/>
  <fp:parameter name="at_bump" value="-40 mm" source="test"/>
  <fp:parameter name="k_bump" value="50 N/mm" source="test"/>
  <fp:parameter name="at_rebound" value="30 mm" source="test"/>
  <fp:parameter name="k_rebound" value="20 N/mm" source="test"/>
  <fp:spring name="fl" parent="top_fl" child="seat_fl">
    <multirate stiffness="$k_fl">
      <knee at="$at_bump" stiffness="$k_bump"/>
      <knee at="$at_rebound" stiffness="$k_rebound"/>
    </multirate>
  </fp:spring>
  <fp:parameter name="k_fr" value="31 N/mm" source="test"/>
  <fp:parameter name="k3_fr" value="400 kN/m^3" source="test"/>
  <fp:spring name="fr" parent="top_fr" child="seat_fr"><cubic stiffness="$k_fr" cubic="$k3_fr"/></fp:spring>
  <fp:parameter name="f_helper" value="-300 N" source="test"/>
  <fp:parameter name="k_helper" value="3 N/mm" source="test"/>
  <fp:spring name="helper" parent="top_fl" child="panhard_axle">
    <linear stiffness="$k_helper" preload="$f_helper"/>
  </fp:spring>
  <fp:frame name="reaction" link="chassis" xyz="0.9 0 -0.1"/>
  <fp:frame name="lever" link="axle" xyz="-0.35 0.02 0"/>
  <fp:parameter name="k_reaction" value="80 N/mm" source="test"/>
  <fp:spring name="reaction" parent="reaction" child="lever"><linear stiffness="$k_reaction"/></fp:spring>
  <fp:frame name="top_rl" link="chassis" xyz="-1.25 0.55 0.05"/>
  <fp:frame name="top_rr" link="chassis" xyz="-1.25 -0.55 0.05"/>
  <fp:frame name="seat_rl" link="arm" xyz="-0.35 0 0.02"/>
  <fp:frame name="seat_rr" link="hinged" xyz="-0.35 0 0.02"/>
  <fp:parameter name="k_rl" value="35 N/mm" source="test"/>
  <fp:spring name="rl" parent="top_rl" child="seat_rl" axis="0.05 -0.1 1"><linear stiffness="$k_rl"/></fp:spring>
  <fp:parameter name="k_rr" value="36 N/mm" source="test"/>
  <fp:parameter name="l_rr" value="0.33 m" source="test"/>
  <fp:spring name="rr" parent="top_rr" child="seat_rr"><linear stiffness="$k_rr" free_length="$l_rr"/></fp:spring>
  <fp:frame name="hook" link="chassis" xyz="-0.5 0.2 -0.05"/>
  <fp:frame name="tail" link="exhaust" xyz="-0.8 0 0"/>
  <fp:parameter name="k_hook" value="9 N/mm" source="test"/>
  <fp:spring name="hook" parent="hook" child="tail"><linear stiffness="$k_hook"/></fp:spring>

  <fp:parameter name="gap_bump" value="15 mm" source="test"/>
  <fp:parameter name="k_stop" value="200 N/mm" source="test"/>
  <fp:parameter name="k3_stop" value="50 MN/m^3" source="test"/>
  <fp:parameter name="gap_rebound" value="16 mm" source="test"/>
  <fp:stop name="rl" parent="top_rl" child="seat_rl">
    <bump gap="$gap_bump" stiffness="$k_stop" cubic="$k3_stop"/>
    <rebound gap="$gap_rebound" stiffness="0.5*$k_stop" cubic="0.5*$k3_stop"/>
  </fp:stop>
  <fp:stop name="rr" parent="top_rr" child="seat_rr" axis="0 0 1"><bump gap="$gap_bump" stiffness="$k_stop"/></fp:stop>

  <fp:frame name="shock_fl" link="chassis" xyz="1.15 0.4 0.15"/>
  <fp:frame name="shock_fr" link="chassis" xyz="1.15 -0.4 0.15"/>
  <fp:frame name="eye_fl" link="axle" xyz="-0.05 0.55 0"/>
  <fp:frame name="eye_fr" link="axle" xyz="-0.05 -0.55 0"/>
  <fp:frame name="shock_rl" link="chassis" xyz="-1.1 0.5 0.12"/>
  <fp:frame name="shock_rr" link="chassis" xyz="-1.1 -0.5 0.12"/>
  <fp:frame name="eye_rl" link="arm" xyz="-0.38 0.02 0"/>
  <fp:frame name="eye_rr" link="hinged" xyz="-0.38 -0.02 0"/>
  <fp:parameter name="c_bump" value="1.2 kN*s/m" source="test"/>
  <fp:parameter name="c_rebound" value="2.5 kN*s/m" source="test"/>
  <fp:parameter name="v_smooth" value="0.05 m/s" source="test"/>
  <fp:parameter name="k_mount" value="400 N/mm" source="test"/>
  <fp:damper name="fl" parent="shock_fl" child="eye_fl">
    <smooth bump="$c_bump" rebound="$c_rebound" speed="$v_smooth"/>
    <series stiffness="$k_mount"/>
  </fp:damper>
  <fp:parameter name="v_bump" value="0.06 m/s" source="test"/>
  <fp:parameter name="v_rebound" value="0.07 m/s" source="test"/>
  <fp:parameter name="c_beyond" value="0.5 kN*s/m" source="test"/>
  <fp:parameter name="k3_mount" value="5000 MN/m^3" source="test"/>
  <fp:parameter name="f_friction" value="40 N" source="test"/>
  <fp:parameter name="v_friction" value="3 mm/s" source="test"/>
  <fp:damper name="fr" parent="shock_fr" child="eye_fr">
    <digressive bump="$c_bump" rebound="$c_rebound" bump_knee="$v_bump" rebound_knee="$v_rebound"
      bump_beyond="$c_beyond" rebound_beyond="2*$c_beyond"/>
    <series stiffness="$k_mount" cubic="$k3_mount"/>
    <friction force="$f_friction" speed="$v_friction"/>
  </fp:damper>
  <fp:parameter name="v_table" value="0.1 m/s" source="test"/>
  <fp:parameter name="f_table" value="150 N" source="test"/>
  <fp:parameter name="f_gas" value="120 N" source="test"/>
  <fp:parameter name="k_gas" value="2 N/mm" source="test"/>
  <fp:damper name="rl" parent="shock_rl" child="eye_rl">
    <table>
      <point speed="-4*$v_table" force="-2*$f_table"/><point speed="-$v_table" force="-$f_table"/>
      <point speed="$v_table" force="2*$f_table"/><point speed="5*$v_table" force="4*$f_table"/>
    </table>
    <friction force="$f_friction"/>
    <gas force="$f_gas" stiffness="$k_gas"/>
  </fp:damper>
  <fp:parameter name="bleed" value="0.6 mm^2" source="test"/>
  <fp:parameter name="valve" value="10 MPa*s/kg" source="test"/>
  <fp:parameter name="oil" value="300 MPa" source="test"/>
  <fp:parameter name="bore" value="30 mm" source="test"/>
  <fp:parameter name="rod" value="12 mm" source="test"/>
  <fp:parameter name="column" value="100 mm" source="test"/>
  <fp:parameter name="p_gas" value="2 MPa" source="test"/>
  <fp:parameter name="V_gas" value="60 cm^3" source="test"/>
  <fp:parameter name="f_seal" value="50 N" source="test"/>
  <fp:parameter name="v_seal" value="5 mm/s" source="test"/>
  <fp:damper name="rr" parent="shock_rr" child="eye_rr">
    <hydraulic bleed="$bleed" rebound_valve="$valve" bump_valve="0.3*$valve" bulk_modulus="$oil" piston="$bore"
      rod="$rod" rebound_column="$column" bump_column="$column" gas_pressure="$p_gas" gas_volume="$V_gas"/>
    <friction force="$f_seal" speed="$v_seal"/>
  </fp:damper>
  <fp:parameter name="k_top" value="600 N/mm" source="test"/>
  <fp:damper name="top" parent="shock_rr" child="seat_rr">
    <hydraulic bleed="$bleed" rebound_valve="2*$valve"/>
    <series stiffness="$k_top"/>
  </fp:damper>
  <fp:parameter name="c_tail" value="50 N*s/m" source="test"/>
  <fp:damper name="tail" parent="hook" child="tail" axis="0.2 0 1"><linear rate="$c_tail"/></fp:damper>
  <fp:damper name="torque" parent="reaction" child="lever">
    <bilinear bump="$c_bump" rebound="$c_rebound"/>
  </fp:damper>

  <fp:frame name="mount_left" link="chassis" xyz="1.1 0.25 -0.05" rpy="0.5 0.2 0.1"/>
  <fp:frame name="mount_right" link="chassis" xyz="1.1 -0.25 -0.05" rpy="-0.5 0.2 -0.1"/>
  <fp:frame name="mount_rear" link="chassis" xyz="0.4 0 0" rpy="0 0.7 0"/>
  <fp:frame name="foot_left" link="engine" xyz="0.2 0.25 -0.1"/>
  <fp:frame name="foot_right" link="engine" xyz="0.2 -0.25 -0.1"/>
  <fp:frame name="foot_rear" link="engine" xyz="-0.5 0 -0.05"/>
  <fp:parameter name="k_x" value="300 N/mm" source="test"/>
  <fp:parameter name="k_y" value="250 N/mm" source="test"/>
  <fp:parameter name="k_z" value="400 N/mm" source="test"/>
  <fp:parameter name="kr" value="200 N*m/rad" source="test"/>
  <fp:parameter name="c_mount" value="300 N*s/m" source="test"/>
  <fp:parameter name="cr_mount" value="2 N*m*s/rad" source="test"/>
  <fp:parameter name="loss" value="0.2" source="test"/>
  <fp:bushing name="left" parent="mount_left" child="foot_left" preload="equilibrium">
    <translation x="$k_x" y="$k_y" z="$k_z"/>
    <rotation x="$kr" y="2*$kr" z="3*$kr"/>
    <loss factor="$loss" frequency="12 Hz"/>
  </fp:bushing>
  <fp:bushing name="right" parent="mount_right" child="foot_right" preload="equilibrium">
    <translation x="$k_x" y="$k_y" z="$k_z"/>
    <translation_damping x="$c_mount" y="2*$c_mount" z="3*$c_mount"/>
  </fp:bushing>
  <fp:bushing name="rear" parent="mount_rear" child="foot_rear" preload="equilibrium">
    <translation x="$k_x" y="$k_y" z="$k_z"/>
    <rotation x="3*$kr" y="2*$kr" z="$kr"/>
    <rotation_damping x="$cr_mount" y="2*$cr_mount" z="3*$cr_mount"/>
  </fp:bushing>
  <fp:frame name="hanger" link="chassis" xyz="-0.5 0.2 -0.25" rpy="0.1 0.2 0.3"/>
  <fp:bushing name="hanger" parent="hanger" child="tail">
    <translation x="0.1*$k_x" y="0.1*$k_y"/>
    <rotation x="$kr"/>
  </fp:bushing>

  <fp:frame name="bar_left" link="chassis" xyz="1.1 0.45 0"/>
  <fp:frame name="bar_right" link="chassis" xyz="1.1 -0.45 0"/>
  <fp:frame name="drop_left" link="axle" xyz="-0.1 0.48 0.05"/>
  <fp:frame name="drop_right" link="axle" xyz="-0.1 -0.48 0.05"/>
  <fp:parameter name="k_bar" value="12 N/mm" source="test"/>
  <fp:parameter name="c_bar" value="40 N*s/m" source="test"/>
  <fp:antiroll name="front" stiffness="$k_bar" damping="$c_bar">
    <left parent="bar_left" child="drop_left"/>
    <right parent="bar_right" child="drop_right" axis="0 0 1"/>
  </fp:antiroll>

  <fp:parameter name="kt" value="200 kN/m" source="test"/>
  <fp:parameter name="ct" value="100 N*s/m" source="test"/>
  <fp:parameter name="k_side" value="120 kN/m" source="test"/>
  <fp:parameter name="k_along" value="20 kN/m" source="test"/>
  <fp:parameter name="c_side" value="60 N*s/m" source="test"/>
  <fp:parameter name="c_along" value="30 N*s/m" source="test"/>
  <fp:tyre name="fl" link="axle" xyz="0 0.7 0" stiffness="$kt" damping="$ct" radius="0.35 m" lateral="$k_side"
    longitudinal="$k_along"/>
  <fp:tyre name="fr" link="axle" xyz="0 -0.7 0" stiffness="$kt" radius="0.35 m" lateral="$k_side"/>
  <fp:tyre name="rl" link="hub" xyz="0 0.03 0" stiffness="1.1*$kt" damping="$ct" radius="0.35 m" lateral="$k_side"
    lateral_damping="$c_side" longitudinal_damping="$c_along"/>
  <fp:tyre name="rr" link="hinged" xyz="-0.4 -0.1 -0.05" stiffness="1.1*$kt" radius="0.35 m" lateral="$k_side"
    longitudinal="$k_along"/>
  <fp:post name="fl" under="fl"/>
  <fp:post name="fr" under="fr"/>
  <fp:post name="rr" under="rr"/>
  <fp:post name="rl" under="rl"/>

  <fp:sensor name="a" type="accelerometer" link="chassis" xyz="0.5 0.3 0.2" axis="0.3 -0.2 1"/>
  <fp:sensor name="a_hub" type="accelerometer" link="hub" xyz="0.1 0 0"/>
  <fp:sensor name="z" type="displacement" link="axle" xyz="0.1 0.6 0.1" axis="0.1 1 0.5"/>
  <fp:sensor name="pitch" type="gyro" link="engine" axis="0.3 1 0.1"/>
  <fp:sensor name="s" type="strut" parent="top_rr" child="seat_rr"/>
  <fp:sensor name="s_guided" type="strut" parent="top_rl" child="seat_rl" axis="0 0.1 1"/>
  <fp:parameter name="m_pan" value="8 kg" source="test"/>
  <fp:sensor name="F_fl" type="load_cell" tyre="fl" wheelpan="$m_pan"/>
  <fp:sensor name="F_rl" type="load_cell" tyre="rl" wheelpan="0.5*$m_pan"/>
  <fp:sensor name="F_rr" type="load_cell" tyre="rr"/>
</robot>
)";

/// A vehicle file's text, which must read without a finding.
inline Vehicle VehicleOf(const std::string& text) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) /
                                     (std::string(test->test_suite_name()) + "." + test->name() + ".urdf");
  std::ofstream(path, std::ios::binary) << text;
  Diagnostics diagnostics;
  const std::optional<Vehicle> vehicle = ReadVehicle(path, diagnostics);
  std::filesystem::remove(path);
  EXPECT_EQ(diagnostics.Format(), "");
  return vehicle.value();
}

inline Vehicle ElementCar() { return VehicleOf(kElementCar); }

}  // namespace fourpost
