#include "vehicles/mirror.h"

#include <complex>
#include <utility>
#include <vector>

#include "tests/vehicles/small_vehicle.h"
#include "vehicles/condensed_vehicle.h"
#include "vehicles/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

const std::string kMirror = R"(<fp:mirror from="_left" to="_right"/>)";

/// What a tag becomes on the other side, as text.
class MirrorTags : public VehicleFileTest {
 protected:
  /// The robot's tags with their twins, without the mirrors.
  std::string Mirrored(const std::string& tags, const std::string& mirrors = kMirror) {
    tinyxml2::XMLDocument document;
    const std::string text = "<robot>" + tags + "\n" + mirrors + "</robot>";
    EXPECT_EQ(document.Parse(text.c_str()), tinyxml2::XML_SUCCESS);
    FileFaults faults(folder_ / "vehicle.urdf", diagnostics_);
    AddTwins(*document.RootElement(), faults);
    tinyxml2::XMLPrinter printer(nullptr, true);
    for (const XMLElement* tag : Children(std::as_const(*document.RootElement())))
      if (std::string_view(tag->Name()) != "fp:mirror") tag->Accept(&printer);
    return printer.CStr();
  }

  void ExpectTwin(const std::string& tag, const std::string& twin) { EXPECT_EQ(Mirrored(tag), tag + twin); }
};

TEST_F(MirrorTags, MirrorsPoints) {
  ExpectTwin(R"(<fp:frame name="top_left" link="body" xyz="1 2.5 -3" rpy="0.1 0.2 0.3"/>)",
             R"(<fp:frame name="top_right" link="body" xyz="1 -2.5 -3" rpy="-0.1 0.2 -0.3"/>)");
}

TEST_F(MirrorTags, KeepsThePlaneOfSymmetry) {
  ExpectTwin(R"(<fp:frame name="top_left" link="body" xyz="1 0 3" rpy="0 0.2 0"/>)",
             R"(<fp:frame name="top_right" link="body" xyz="1 0 3" rpy="0 0.2 0"/>)");
}

TEST_F(MirrorTags, MirrorsInertia) {
  ExpectTwin(R"(<link name="a_left"><inertial><origin xyz="1 2 3" rpy="1 2 3"/><mass value="1"/>)"
             R"(<inertia ixx="1" iyy="2" izz="3" ixy="0.1" ixz="0.2" iyz="-0.3"/></inertial></link>)",
             R"(<link name="a_right"><inertial><origin xyz="1 -2 3" rpy="-1 2 -3"/><mass value="1"/>)"
             R"(<inertia ixx="1" iyy="2" izz="3" ixy="-0.1" ixz="0.2" iyz="0.3"/></inertial></link>)");
}

TEST_F(MirrorTags, MirrorsShapes) {
  ExpectTwin(R"(<link name="a_left"><visual name="x_left"><geometry><mesh filename="a_left" scale="1 2 3"/></geometry>)"
             R"(</visual><visual><geometry><box size="1 2 3"/></geometry></visual></link>)",
             R"(<link name="a_right"><visual name="x_left"><geometry><mesh filename="a_left" scale="1 -2 3"/>)"
             R"(</geometry></visual><visual><geometry><box size="1 2 3"/></geometry></visual></link>)");
}

std::string JointText(const std::string& side, const std::string& type, const std::string& axis) {
  return R"(<joint name="j_)" + side + R"(" type=")" + type + "\">" + axis + "</joint>";
}

TEST_F(MirrorTags, MirrorsDirectionsOfMotion) {
  for (const std::string type : {"prismatic", "planar"})
    ExpectTwin(JointText("left", type, R"(<axis xyz="1 2 3"/>)"), JointText("right", type, R"(<axis xyz="1 -2 3"/>)"));
}

TEST_F(MirrorTags, MirrorsAxesOfTurning) {
  for (const std::string type : {"revolute", "continuous"}) {
    ExpectTwin(JointText("left", type, R"(<axis xyz="1 2 3"/>)"), JointText("right", type, R"(<axis xyz="-1 2 -3"/>)"));
    ExpectTwin(JointText("left", type, "<a/>"), JointText("right", type, R"(<a/><axis xyz="-1 0 0"/>)"));
  }
}

TEST_F(MirrorTags, MirrorsAxesOfSensors) {
  ExpectTwin(R"(<fp:sensor name="s_left" type="accelerometer" axis="1 2 3"/>)",
             R"(<fp:sensor name="s_right" type="accelerometer" axis="1 -2 3"/>)");
  ExpectTwin(R"(<fp:sensor name="s_left" type="gyro" axis="1 2 3"/>)",
             R"(<fp:sensor name="s_right" type="gyro" axis="-1 2 -3"/>)");
}

TEST_F(MirrorTags, MirrorsHinges) {
  ExpectTwin(R"(<fp:hinge name="h_left" parent="a" child="b" axis="1 2 3"/>)",
             R"(<fp:hinge name="h_right" parent="a" child="b" axis="-1 2 -3"/>)");
}

TEST_F(MirrorTags, FollowsReferences) {
  EXPECT_EQ(
      Mirrored(R"(<link name="a_left"/><joint name="j_left"><parent link="body"/><child link="a_left"/></joint>)"),
      R"(<link name="a_left"/><link name="a_right"/>)"
      R"(<joint name="j_left"><parent link="body"/><child link="a_left"/></joint>)"
      R"(<joint name="j_right"><parent link="body"/><child link="a_right"/></joint>)");
}

// A tag may join both sides.
TEST_F(MirrorTags, FollowsReferencesBack) {
  EXPECT_EQ(Mirrored(R"(<link name="a_left"/><fp:rod name="r_left" parent="a_left" child="a_right"/>)"),
            R"(<link name="a_left"/><link name="a_right"/><fp:rod name="r_left" parent="a_left" child="a_right"/>)"
            R"(<fp:rod name="r_right" parent="a_right" child="a_left"/>)");
}

TEST_F(MirrorTags, LetsWhatIsWrittenStand) {
  const std::string both = R"(<link name="a_left"/><link name="a_right" type="x"/>)";
  EXPECT_EQ(Mirrored(both), both);
  // Only a tag of the same kind takes the name.
  EXPECT_EQ(Mirrored(R"(<link name="a_left"/><fp:frame name="a_right"/>)"),
            R"(<link name="a_left"/><link name="a_right"/><fp:frame name="a_right"/>)");
}

TEST_F(MirrorTags, LetsParametersAndForeignTagsBe) {
  EXPECT_EQ(Mirrored(R"(<link name="a_left"/><material name="m_left"/><x:lamp name="l_left"/>)"
                     R"(<fp:parameter name="p_left"/>)"),
            R"(<link name="a_left"/><link name="a_right"/><material name="m_left"/><x:lamp name="l_left"/>)"
            R"(<fp:parameter name="p_left"/>)");
}

TEST_F(MirrorTags, TakesTagsWithoutANameByTheirLink) {
  EXPECT_EQ(Mirrored(R"(<link name="a_left"/><fp:solid link="a_left" density="$d"/><fp:solid link="body"/>)"),
            R"(<link name="a_left"/><link name="a_right"/><fp:solid link="a_left" density="$d"/>)"
            R"(<fp:solid link="a_right" density="$d"/><fp:solid link="body"/>)");
}

// A written link brings its own mass.
TEST_F(MirrorTags, LeavesWrittenLinksWithoutASolid) {
  const std::string both = R"(<link name="a_left"/><link name="a_right"/><fp:solid link="a_left"/>)";
  EXPECT_EQ(Mirrored(both), both);
}

TEST_F(MirrorTags, BindsTwins) {
  EXPECT_EQ(
      Mirrored(
          R"(<link name="a_left"/><fp:parameter name="p"><fp:bind to="link[a_left]/mass" factor="2"/>)"
          R"(<fp:bind to="link[b]/mass"/></fp:parameter><fp:parameter name="q"><fp:bind )"
          R"(to="link[a_left]/inertia/ixy"/><fp:bind to="link[a_left]/inertia/iyz" factor="0.5"/></fp:parameter>)"),
      R"(<link name="a_left"/><link name="a_right"/><fp:parameter name="p"><fp:bind to="link[a_left]/mass" factor="2"/>)"
      R"(<fp:bind to="link[a_right]/mass" factor="2"/><fp:bind to="link[b]/mass"/></fp:parameter>)"
      R"(<fp:parameter name="q"><fp:bind to="link[a_left]/inertia/ixy"/>)"
      R"(<fp:bind to="link[a_right]/inertia/ixy" factor="-1"/><fp:bind to="link[a_left]/inertia/iyz" factor="0.5"/>)"
      R"(<fp:bind to="link[a_right]/inertia/iyz" factor="-0.5"/></fp:parameter>)");
}

TEST_F(MirrorTags, BindsTwinsWithTheSignOfTheirSide) {
  for (const auto& [number, factor] : std::vector<std::pair<std::string, std::string>>{{"mass", "2"},
                                                                                       {"com/x", "2"},
                                                                                       {"com/y", "-2"},
                                                                                       {"com/z", "2"},
                                                                                       {"inertia/ixx", "2"},
                                                                                       {"inertia/iyy", "2"},
                                                                                       {"inertia/izz", "2"},
                                                                                       {"inertia/ixy", "-2"},
                                                                                       {"inertia/ixz", "2"},
                                                                                       {"inertia/iyz", "-2"}})
    EXPECT_EQ(Mirrored(R"(<link name="a_left"/><fp:parameter name="p"><fp:bind to="link[a_left]/)" + number +
                       R"(" factor="2"/></fp:parameter>)"),
              R"(<link name="a_left"/><link name="a_right"/><fp:parameter name="p"><fp:bind to="link[a_left]/)" +
                  number + R"(" factor="2"/><fp:bind to="link[a_right]/)" + number + R"(" factor=")" + factor +
                  R"("/></fp:parameter>)");
}

TEST_F(MirrorTags, LeavesBindsOfWrittenLinks) {
  const std::string tags = R"(<link name="a_left"/><link name="a_right"/>)"
                           R"(<fp:parameter name="p"><fp:bind to="link[a_left]/mass"/></fp:parameter>)";
  EXPECT_EQ(Mirrored(tags), tags);
}

TEST_F(MirrorTags, ObeysSeveralMirrors) {
  EXPECT_EQ(Mirrored(R"(<link name="FL"/><link name="RL"/>)",
                     R"(<fp:mirror from="FL" to="FR"/><fp:mirror from="RL" to="RR"/>)"),
            R"(<link name="FL"/><link name="FR"/><link name="RL"/><link name="RR"/>)");
}

std::string Bar(const std::string& name, const std::string& right) {
  return R"(<fp:frame name="a_left"/><fp:frame name="a_right"/><fp:antiroll name=")" + name +
         R"("><left parent="a_left" child="body"/><right parent=")" + right + R"(" child="body"/></fp:antiroll>)";
}

TEST_F(MirrorTags, LeaveABarSingleThatIsItsOwnTwin) {
  EXPECT_EQ(Mirrored(Bar("bar_left", "a_right")), Bar("bar_left", "a_right"));
  Expect(Severity::kWarning, 1,
         "fp:antiroll 'bar_left' is its own mirror image, so <fp:mirror> leaves it single: end its name otherwise than "
         "in '_left'");
}

TEST_F(MirrorTags, DoubleABarOfOneSide) {
  EXPECT_EQ(Mirrored(Bar("bar_left", "middle")),
            Bar("bar_left", "middle") + R"(<fp:antiroll name="bar_right"><left parent="a_right" child="body"/>)"
                                        R"(<right parent="middle" child="body"/></fp:antiroll>)");
}

TEST_F(MirrorTags, DoesNotMirrorTwins) {
  EXPECT_EQ(Mirrored(R"(<link name="a_1"/>)", R"(<fp:mirror from="_1" to="_2"/><fp:mirror from="a_1" to="b_1"/>)"),
            R"(<link name="a_1"/><link name="b_1"/><link name="a_2"/>)");
}

/// Lines of one corner of a double wishbone axle, and of the other: links turned by fixed joints, skewed axes, loops.
const std::vector<std::pair<std::string, std::string>>& Corners() {
  static const std::string mesh = std::string(FOURPOST_SOURCE_DIR) + "/meshes/wheel.obj";
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
       R"(<bilinear compression="1 kN*s/m" rebound="2 kN*s/m"/></fp:damper>)",
       R"(<fp:damper name="shock_right" parent="top_right" child="seat_right" axis="0 -0.2 1">)"
       R"(<bilinear compression="1 kN*s/m" rebound="2 kN*s/m"/></fp:damper>)"},
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

constexpr unsigned kLeft = 1;
constexpr unsigned kRight = 2;

/// A bind to a number of each side that is written out.
std::string Binds(unsigned sides, const std::string& link, const std::string& number, const std::string& right_sign) {
  std::string text;
  const auto bind = [&](const std::string& side, const std::string& sign) {
    text += "<fp:bind to=\"link[" + link + side + "]/" + number + "\" factor=\"" + sign + "2\"/>\n";
  };
  if ((sides & kLeft) != 0) bind("_left", "");
  if ((sides & kRight) != 0) bind("_right", right_sign);
  return text;
}

/// An axle whose body moves up and rolls, with these corners written out.
std::string Axle(unsigned sides, const std::string& more = "") {
  std::string text = R"(<robot name="axle" xmlns:fp="urn:fourpost:vehicle:1"><link name="ground"/><link name="heave"/>
<link name="body"><inertial><mass value="600"/><inertia ixx="150" iyy="300" izz="300" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="heave" type="prismatic"><parent link="ground"/><child link="heave"/><origin xyz="0 0 0.5"/><axis xyz="0 0 1"/>
<limit effort="0" velocity="0"/></joint>
<joint name="roll" type="continuous"><parent link="heave"/><child link="body"/></joint>
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

std::string NameOf(const Spring& spring) { return spring.Element(); }
std::string NameOf(const auto& element) { return element.name; }

template <typename T>
const T& Named(const std::vector<T>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const T& one) { return NameOf(one) == name; });
  if (found == all.end()) throw std::out_of_range("no '" + name + "'");
  return *found;
}

void ExpectSame(const Scalar& a, const Scalar& b) {
  EXPECT_EQ(a.value, b.value);
  EXPECT_EQ(a.parameter, b.parameter);
  EXPECT_EQ(a.factor, b.factor);
}

/// Two vehicles that must hold the same elements, in any order. All numbers are the same text, so equal to the last
/// bit.
class Comparison {
 public:
  Comparison(const Vehicle& a, const Vehicle& b) : a_(a), b_(b) {}

  void Compare() const {
    ForEach(a_.links, b_.links, [](const Link& a, const Link& b) {
      ExpectSame(a.mass, b.mass);
      for (std::size_t i = 0; i < a.com.size(); ++i) ExpectSame(a.com[i], b.com[i]);
      for (std::size_t i = 0; i < a.inertia.size(); ++i) ExpectSame(a.inertia[i], b.inertia[i]);
      ASSERT_EQ(a.visuals.size(), b.visuals.size());
      for (std::size_t i = 0; i < a.visuals.size(); ++i) {
        EXPECT_EQ(a.visuals[i].pose.matrix(), b.visuals[i].pose.matrix());
        EXPECT_EQ(a.visuals[i].size, b.visuals[i].size);
        EXPECT_EQ(a.visuals[i].mesh_file, b.visuals[i].mesh_file);
      }
    });
    ForEach(a_.joints, b_.joints, [&](const Joint& a, const Joint& b) {
      EXPECT_EQ(a.type, b.type);
      EXPECT_EQ(LinkName(a_, a.parent), LinkName(b_, b.parent));
      EXPECT_EQ(LinkName(a_, a.child), LinkName(b_, b.child));
      EXPECT_EQ(a.pose.matrix(), b.pose.matrix());
      EXPECT_EQ(a.axis, b.axis);
    });
    CompareForces();
  }

 private:
  void CompareForces() const {
    ForEach(a_.springs, b_.springs, [&](const Spring& a, const Spring& b) {
      SameLine(a.line, b.line);
      ExpectSame(a.law.stiffness, b.law.stiffness);
    });
    ForEach(a_.dampers, b_.dampers, [&](const Damper& a, const Damper& b) {
      SameLine(a.line, b.line);
      ExpectSame(a.law.rebound, b.law.rebound);
    });
    ForEach(a_.bushings, b_.bushings, [&](const Bushing& a, const Bushing& b) {
      SamePoint(a.parent, b.parent);
      SamePoint(a.child, b.child);
      EXPECT_EQ(a.axes, b.axes);
      ExpectSame(a.stiffness[5], b.stiffness[5]);
    });
    ForEach(a_.tyres, b_.tyres, [&](const Tyre& a, const Tyre& b) {
      SamePoint(a.point, b.point);
      ExpectSame(a.damping, b.damping);
    });
    ForEach(a_.posts, b_.posts,
            [&](const Post& a, const Post& b) { EXPECT_EQ(TyreName(a_, a.tyre), TyreName(b_, b.tyre)); });
    const auto same_ends = [&](const auto& a, const auto& b) {
      SamePoint(a.parent, b.parent);
      SamePoint(a.child, b.child);
    };
    ForEach(a_.rods, b_.rods, same_ends);
    ForEach(a_.balls, b_.balls, same_ends);
    ForEach(a_.sensors, b_.sensors, [&](const Sensor& a, const Sensor& b) {
      EXPECT_EQ(a.type, b.type);
      EXPECT_EQ(a.axis, b.axis);
      SamePoint(a.point, b.point);
      SameLine(a.line, b.line);
      EXPECT_EQ(TyreName(a_, a.tyre), TyreName(b_, b.tyre));
    });
  }

  template <typename T, typename Compare>
  static void ForEach(const std::vector<T>& a, const std::vector<T>& b, Compare compare) {
    ASSERT_EQ(a.size(), b.size());
    for (const T& one : a) {
      SCOPED_TRACE(NameOf(one));
      compare(one, Named(b, NameOf(one)));
    }
  }

  static std::string LinkName(const Vehicle& vehicle, int link) {
    return link < 0 ? "" : vehicle.links.at(static_cast<std::size_t>(link)).name;
  }
  static std::string TyreName(const Vehicle& vehicle, int tyre) {
    return tyre < 0 ? "" : vehicle.tyres.at(static_cast<std::size_t>(tyre)).name;
  }
  void SamePoint(const Point& a, const Point& b) const {
    EXPECT_EQ(LinkName(a_, a.link), LinkName(b_, b.link));
    EXPECT_EQ(a.xyz, b.xyz);
  }
  void SameLine(const ForceLine& a, const ForceLine& b) const {
    SamePoint(a.parent, b.parent);
    SamePoint(a.child, b.child);
    EXPECT_EQ(a.axis, b.axis);
  }

  const Vehicle& a_;
  const Vehicle& b_;
};

class MirrorVehicle : public VehicleFileTest {};

TEST_F(MirrorVehicle, EqualsTheOneWrittenOut) {
  const Vehicle whole = Read(Axle(kLeft | kRight)).value();
  const Vehicle mirrored = Read(Axle(kLeft, kMirror)).value();
  Comparison(whole, mirrored).Compare();
  const CondensedModel a = CondensedVehicle(whole).At(whole.ParameterValues());
  const CondensedModel b = CondensedVehicle(mirrored).At(mirrored.ParameterValues());
  EXPECT_EQ(a.mass.rows(), 4);
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(a.stiffness, b.stiffness);
  EXPECT_EQ(a.post_stiffness, b.post_stiffness);
  EXPECT_EQ(a.on_acceleration, b.on_acceleration);
}

TEST_F(MirrorVehicle, EqualsTheOneMirroredBack) {
  const Vehicle whole = Read(Axle(kLeft | kRight)).value();
  Comparison(whole, Read(Axle(kRight, R"(<fp:mirror from="_right" to="_left"/>)")).value()).Compare();
}

/// Sensor readings for posts that move as `post` at one frequency, without dampers.
Eigen::VectorXcd Readings(const CondensedModel& model, const Eigen::VectorXcd& post) {
  const std::complex<double> s(0, 30);
  const Eigen::MatrixXcd dynamic = model.mass * (s * s) + model.damping * s + model.stiffness;
  const Eigen::VectorXcd motion = dynamic.lu().solve((model.post_stiffness + model.post_damping * s) * post);
  return (model.on_position + model.on_velocity * s + model.on_acceleration * (s * s)) * motion +
         (model.on_post_height + model.on_post_velocity * s) * post;
}

// What the mirror must do, whatever its rules: both sides move alike when driven alike, and opposite when opposite.
TEST_F(MirrorVehicle, MovesAlikeOnBothSides) {
  const Vehicle vehicle = Read(Axle(kLeft, kMirror)).value();
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const Eigen::VectorXcd heave = Readings(model, Eigen::Vector2cd(1, 1));
  const Eigen::VectorXcd roll = Readings(model, Eigen::Vector2cd(1, -1));
  // Rounding of matrices whose condition is about 1e4.
  constexpr double kRounding = 1e-10;
  EXPECT_LT(std::abs(heave[0] - heave[1]), kRounding * std::abs(heave[1])) << "the body does not roll";
  EXPECT_LT(std::abs(roll[1]), kRounding * std::abs(roll[0])) << "the body does not heave";
  for (std::size_t i = 2; i < vehicle.sensors.size(); i += 2) {
    const auto left = static_cast<Eigen::Index>(i);
    EXPECT_GT(std::abs(heave[left]), 1e-3) << vehicle.sensors[i].name << " tells nothing";
    EXPECT_LT(std::abs(heave[left] - heave[left + 1]), kRounding * std::abs(heave[left])) << vehicle.sensors[i].name;
    EXPECT_LT(std::abs(roll[left] + roll[left + 1]), kRounding * std::abs(roll[left])) << vehicle.sensors[i].name;
  }
}

TEST_F(MirrorVehicle, HasTheLinesOfWhatItMirrors) {
  const std::string text = Axle(kLeft, kMirror);
  const Vehicle vehicle = Read(text).value();
  EXPECT_EQ(Named(vehicle.links, "hub_right").line, LineOf(text, R"(<link name="hub_left")"));
  EXPECT_EQ(vehicle.tyres.at(1).name, "tyre_right");
  EXPECT_EQ(vehicle.tyres.at(1).source_line, LineOf(text, "<fp:tyre"));
}

TEST_F(MirrorVehicle, FollowsNewValues) {
  const std::string text = Axle(kLeft, kMirror);
  const Vehicle vehicle = Read(text).value();
  const std::vector<double> values = {70e3, 12, 0.004, 0.016};
  const std::string rewritten = VehicleTextWithValues(vehicle, values, folder_);
  std::string expected = Replaced(text, R"(value="80 N/mm")", R"(value="70 N/mm")");
  expected = Replaced(expected, R"(value="10 kg")", R"(value="12 kg")");
  expected = Replaced(expected, R"(<mass value="20"/>)", R"(<mass value="24"/>)");
  expected = Replaced(expected, "0.005 kg", "0.004 kg");
  expected = Replaced(expected, R"(ixy="0.01")", R"(ixy="0.008")");
  expected = Replaced(expected, R"(value="15 mm")", R"(value="16 mm")");
  expected = Replaced(expected, R"(<origin xyz="0 0.03 0"/>)", R"(<origin xyz="0 0.032 0"/>)");
  EXPECT_EQ(rewritten, expected);
  const Vehicle again = Read(rewritten).value();
  EXPECT_EQ(again.ParameterValues(), values);
  EXPECT_EQ(Named(again.links, "hub_right").mass.value, 24);
  EXPECT_EQ(Named(again.links, "knuckle_right").inertia[3].value, -0.008);
  EXPECT_EQ(Named(again.links, "knuckle_right").com[1].value, -0.032);
}

TEST_F(MirrorVehicle, TakesAWrittenTwin) {
  const std::string stiff =
      R"(<fp:tyre name="tyre_right" link="hub_right" xyz="0 -0.02 0" stiffness="300 kN/m"/>)" + kMirror;
  const Vehicle vehicle = Read(Axle(kLeft, stiff)).value();
  ASSERT_EQ(vehicle.tyres.size(), 2U);
  EXPECT_EQ(vehicle.tyres[1].stiffness.value, 3e5);
  EXPECT_EQ(vehicle.posts.at(1).tyre, 1);
}

class MirrorFaults : public VehicleFileTest {
 protected:
  void ExpectOnly(const std::string& more, const std::string& part) {
    const std::string text = Axle(kLeft, more + "\n");
    EXPECT_FALSE(Read(text).has_value());
    Expect(Severity::kError, LineOf(text, more), part);
  }
};

TEST_F(MirrorFaults, KnowTheEndsOfNames) {
  ExpectOnly(R"(<fp:mirror from="_lefft" to="_right"/>)",
             R"(from="_lefft" of <fp:mirror> is the end of no name, did you mean '_left'?)");
}

TEST_F(MirrorFaults, NeedAnotherEnd) {
  ExpectOnly(R"(<fp:mirror from="_left" to="_left"/>)", R"(to="_left" of <fp:mirror> must differ from its from)");
}

TEST_F(MirrorFaults, NeedAnEnd) {
  ExpectOnly(R"(<fp:mirror from="" to="_right"/>)", R"(from="" of <fp:mirror> is empty)");
}

TEST_F(MirrorFaults, CountMirrors) {
  std::string mirrors;
  for (int i = 0; i < 8; ++i) mirrors += kMirror;
  const std::string ninth = R"(<fp:mirror  from="_left" to="_right"/>)";
  const std::string text = Axle(kLeft, mirrors + "\n" + ninth);
  EXPECT_FALSE(Read(text).has_value());
  Expect(Severity::kError, LineOf(text, ninth), "more than 8 <fp:mirror>");
}

TEST_F(MirrorFaults, LeaveTwinsToTheirSide) {
  const std::string bind = R"(<fp:bind to="link[hub_right]/mass"/>)";
  const std::string text =
      Axle(kLeft, "<fp:parameter name=\"n\" value=\"20 kg\" source=\"test\">\n" + bind + "</fp:parameter>" + kMirror);
  EXPECT_FALSE(Read(text).has_value());
  Expect(Severity::kError, LineOf(text, bind),
         "to=\"link[hub_right]/mass\" of <fp:bind> of fp:parameter 'n' is a number that follows link 'hub_left' by "
         "fp:mirror");
}

// The twin has it too.
TEST_F(MirrorFaults, AreToldOnceForTheOneThatIsWritten) {
  const std::string rod = R"(<fp:rod name="drop_left" parent="tip_left" child="ground"/>)";
  const std::string text = Axle(kLeft, rod + kMirror);
  EXPECT_FALSE(Read(text).has_value());
  Expect(Severity::kError, LineOf(text, rod), "fp:rod 'drop_left' refers to an unknown frame or link 'tip_left'");
}

}  // namespace
}  // namespace fourpost
