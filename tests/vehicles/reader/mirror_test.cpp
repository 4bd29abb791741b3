#include "vehicles/reader/mirror.h"

#include <string>
#include <utility>
#include <vector>

#include "tests/vehicles/mirrored_axle.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/reader/findings.h"
#include "vehicles/tags/tag.h"

namespace fourpost::mirror_test {
namespace {

using tinyxml2::XMLElement;

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

TEST_F(MirrorTags, MirrorsShiftsOfPoints) {
  const std::pair<const char*, const char*> shifts[] = {
      {"2 mm", "-2 mm"}, {"-2 mm", "2 mm"}, {"+2 mm", "-2 mm"}, {"0 mm", "0 mm"}, {"-0.5*$dy", "0.5*$dy"}};
  for (const auto& [left, right] : shifts)
    ExpectTwin(R"(<fp:frame name="top_left" link="body" dy=")" + std::string(left) + R"("/>)",
               R"(<fp:frame name="top_right" link="body" dy=")" + std::string(right) + R"("/>)");
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
  Expect(1, kMirrorOfItself, {"fp:antiroll 'bar_left'", "'_left'"});
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

}  // namespace
}  // namespace fourpost::mirror_test
