#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "analysis/signals/random_stream.h"
#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {

// Random dampers with friction, mounts, gas and every dashpot law, and a quarter car that has one.

class DamperDraw {
 public:
  DamperDraw(std::uint64_t seed, std::uint64_t number) : stream_(seed, "damper engines", number) {}
  double Log(double lower, double upper) { return lower * std::pow(upper / lower, stream_.Uniform()); }
  bool Often(double share) { return stream_.Uniform() < share; }

 private:
  RandomStream stream_;
};

inline std::string NumberText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

struct Drawn {
  /// Its numbers, comma-separated, SI.
  std::string row;
  /// Children of its fp:damper.
  std::string elements;
};

inline std::string LawElement(int law, double compression, double rebound) {
  const std::string rates =
      " bump=\"" + NumberText(compression) + " N*s/m\" rebound=\"" + NumberText(rebound) + " N*s/m\"";
  switch (law) {
    case 0: return "<linear rate=\"" + NumberText(compression) + " N*s/m\"/>";
    case 1: return "<bilinear" + rates + "/>";
    case 2: return "<smooth" + rates + " speed=\"30 mm/s\"/>";
    case 3:
      return "<digressive" + rates + " bump_knee=\"0.08 m/s\" bump_beyond=\"" + NumberText(0.4 * compression) +
             " N*s/m\" rebound_knee=\"0.1 m/s\" rebound_beyond=\"" + NumberText(0.4 * rebound) + " N*s/m\"/>";
  }
  std::string points;
  for (const auto& [speed, share] : {std::pair{-0.4, -0.3}, {-0.1, -0.1}, {0.1, 0.1}, {0.4, 0.3}})
    points += "<point speed=\"" + NumberText(speed) + " m/s\" force=\"" +
              NumberText(share * (speed < 0 ? compression : rebound)) + " N\"/>";
  return "<table>" + points + "</table>";
}

/// Stiffness of the mount: none in one of five, else up to `stiffest` [N/m].
inline Drawn DrawDamper(int number, DamperDraw& draw, double stiffest = 1e8) {
  const int law = number % 5;
  const double compression = draw.Log(100, 3000);
  const double rebound = compression * draw.Log(0.3, 6);
  const double friction = draw.Often(0.2) ? 0 : draw.Log(5, 400);
  const double speed = draw.Log(5e-4, 2e-2);
  const double stiffness = draw.Often(0.2) ? 0 : draw.Log(1e5, stiffest);
  const double cubic = draw.Often(0.3) ? stiffness * draw.Log(1e3, 1e6) : 0;
  const double gas = draw.Often(0.3) ? 2000 : 0;
  std::string elements = LawElement(law, compression, rebound);
  if (friction > 0)
    elements += "<friction force=\"" + NumberText(friction) + " N\" speed=\"" + NumberText(speed) + " m/s\"/>";
  if (stiffness > 0)
    elements += "<series stiffness=\"" + NumberText(stiffness) + " N/m\" cubic=\"" + NumberText(cubic) + " N/m^3\"/>";
  if (gas > 0) elements += "<gas force=\"100 N\" stiffness=\"" + NumberText(gas) + " N/m\"/>";
  constexpr const char* kLaws[] = {"linear", "bilinear", "smooth", "digressive", "table"};
  std::string row = kLaws[law];
  for (const double value : {compression, rebound, friction, speed, stiffness, cubic, gas})
    row += "," + NumberText(value);
  return {std::move(row), std::move(elements)};
}

inline Vehicle QuarterCarWith(const std::string& damper) {
  const auto body = [](const std::string& name, const std::string& mass, const std::string& height) {
    return "<link name=\"" + name + "\"><inertial><mass value=\"" + mass +
           "\"/><inertia ixx=\"0\" iyy=\"0\" izz=\"0\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link><joint "
           "name=\"" +
           name + "_travel\" type=\"prismatic\"><parent link=\"ground\"/><child link=\"" + name +
           "\"/><origin xyz=\"0 0 " + height +
           "\"/><axis xyz=\"0 0 1\"/><limit lower=\"-0.2\" upper=\"0.2\" effort=\"0\" velocity=\"0\"/></joint>";
  };
  const std::string text =
      R"(<robot name="quarter" xmlns:fp="urn:fourpost:vehicle:1"><link name="ground"/>)" + body("wheel", "38", "0.3") +
      body("body", "285", "0.7") +
      R"(<fp:spring name="spring" parent="body" child="wheel"><linear stiffness="15 N/mm"/></fp:spring>
<fp:damper name="damper" parent="body" child="wheel">)" +
      damper + R"(</fp:damper>
<fp:tyre name="tyre" link="wheel" xyz="0 0 -0.3" stiffness="250 N/mm" damping="200 N*s/m"/><fp:post name="post" under="tyre"/>
<fp:sensor name="a_body" type="accelerometer" link="body" xyz="0 0 0"/>
<fp:sensor name="a_wheel" type="accelerometer" link="wheel" xyz="0 0 0"/>
<fp:sensor name="s_strut" type="strut" parent="body" child="wheel"/>
<fp:sensor name="F_tyre" type="load_cell" tyre="tyre"/></robot>)";
  Diagnostics diagnostics;
  std::optional<Vehicle> vehicle = ReadVehicleText(text, "quarter.urdf", diagnostics);
  if (!vehicle) throw FaultyInput(diagnostics);
  return std::move(*vehicle);
}

}  // namespace fourpost
