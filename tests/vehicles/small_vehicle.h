#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tests/findings.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {

/// A vehicle file without a fault, with every tag.
inline const std::string kSmallVehicle = R"(<?xml version="1.0"?>
<robot name="small" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="ground"/>
  <link name="wheel">
    <inertial>
      <mass value="22"/>
      <inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/>
    </inertial>
  </link>
  <link name="body">
    <inertial>
      <origin xyz="0.1 0 0.2"/>
      <mass value="200"/>
      <inertia ixx="3" iyy="4" izz="5" ixy="0" ixz="0" iyz="0"/>
    </inertial>
    <visual><geometry><box size="1 2 3"/></geometry></visual>
  </link>
  <joint name="wheel_travel" type="prismatic">
    <parent link="ground"/>
    <child link="wheel"/>
    <origin xyz="0 0 0.3"/>
    <axis xyz="0 0 2"/>
    <limit effort="0" velocity="0"/>
  </joint>
  <joint name="body_turn" type="continuous">
    <parent link="wheel"/>
    <child link="body"/>
    <origin xyz="0 0 0.5" rpy="0 0 1.5707963267948966"/>
    <axis xyz="0 1 0"/>
  </joint>
  <fp:parameter name="m_body" value="200 kg" lower="150 kg" upper="0.25 t" precision="0.1 kg" source="weighed">
    <fp:bind to="link[body]/mass"/>
  </fp:parameter>
  <fp:parameter name="I_body" value="2 kg*m^2" source="estimate">
    <fp:bind to="link[body]/inertia/iyy" factor="2"/>
  </fp:parameter>
  <fp:parameter name="k" value="15 N/mm" lower="10 N/mm" upper="20 N/mm" precision="0.01 N/mm" source="bench"/>
  <fp:frame name="top" link="body" xyz="0.1 0 0.4"/>
  <fp:spring name="coil" parent="top" child="wheel" axis="0 0 2"><linear stiffness="0.5*$k" preload="-2 kN"/></fp:spring>
  <fp:spring name="helper" parent="top" child="ground"><linear stiffness="$k"/></fp:spring>
  <fp:damper name="shock" parent="top" child="wheel">
    <bilinear bump="1 kN*s/m" rebound="2 kN*s/m"/>
    <series stiffness="800 N/mm"/>
  </fp:damper>
  <fp:damper name="hub" parent="top" child="ground"><linear rate="10 N*s/m"/></fp:damper>
  <fp:tyre name="tyre" link="wheel" xyz="0 0 -0.3" stiffness="200 kN/m" damping="50 N*s/m" preload="2 kN"/>
  <fp:post name="post" under="tyre"/>
  <fp:rod name="link" parent="top" child="ground"/>
  <fp:ball name="joint" parent="top" child="ground"/>
  <fp:sensor name="a" type="accelerometer" link="body" xyz="1 0 0"/>
  <fp:sensor name="z" type="displacement" link="body" xyz="0 0 0" axis="0 3 4"/>
  <fp:sensor name="s" type="strut" parent="top" child="wheel"/>
  <fp:sensor name="F" type="load_cell" tyre="tyre"/>
</robot>
)";

/// The text with its only occurrence of `from` replaced.
inline std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos || text.find(from, at + 1) != std::string::npos)
    throw std::invalid_argument("not just once in the text: " + from);
  return text.replace(at, from.size(), to);
}

/// 1-based line of the first occurrence.
inline int LineOf(const std::string& text, const std::string& part) {
  const std::size_t at = text.find(part);
  if (at == std::string::npos) throw std::invalid_argument("not in the text: " + part);
  return static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')) + 1;
}

/// Writes vehicle files and reads them; fails on findings that the test has not taken.
class VehicleFileTest : public ::testing::Test {
 protected:
  VehicleFileTest() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test->test_suite_name()) + "." + test->name();
    std::replace(name.begin(), name.end(), '/', '.');
    folder_ = std::filesystem::path(::testing::TempDir()) / "fourpost" / name;
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }

  void TearDown() override {
    EXPECT_EQ(diagnostics_.Format(), "") << "findings that the test does not expect";
    std::filesystem::remove_all(folder_);
  }

  std::filesystem::path Write(const std::string& text, const std::string& name = "vehicle.urdf") const {
    const std::filesystem::path path = folder_ / name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  std::optional<Vehicle> Read(const std::string& text) { return ReadVehicle(Write(text), diagnostics_); }

  /// Takes one finding of this kind in this line, whose message names each of `words`.
  void Expect(int line, const Finding& kind, const std::vector<std::string>& words = {}) {
    std::vector<Diagnostic> rest = diagnostics_.items();
    const auto found = std::find_if(rest.begin(), rest.end(), [&](const Diagnostic& item) {
      return item.place.line == line && item.place.file == folder_ / "vehicle.urdf" && Is(item, kind, words);
    });
    if (found == rest.end()) {
      ADD_FAILURE() << "expected in line " << line << ": [" << kind.id() << "] " << testing::PrintToString(words)
                    << "\ngot:\n"
                    << diagnostics_.Format();
      diagnostics_ = {};
      return;
    }
    rest.erase(found);
    diagnostics_ = {};
    for (const Diagnostic& item : rest) diagnostics_.Add(item);
  }

  std::filesystem::path folder_;
  Diagnostics diagnostics_;
};

}  // namespace fourpost
