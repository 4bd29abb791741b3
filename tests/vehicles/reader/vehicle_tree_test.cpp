#include "tests/vehicles/small_vehicle.h"

#include "vehicles/reader/findings.h"
#include "vehicles/tags/findings.h"

namespace fourpost::vehicle_tree_test {
namespace {

const std::string kRobot = "<robot name=\"r\">\n";

std::string LinkText(const std::string& name, const std::string& inertial = "") {
  return R"(<link name=")" + name + R"(">)" + inertial + "</link>\n";
}

std::string Inertial(double mass, const std::string& moments = R"(ixx="1" iyy="1" izz="1")") {
  return R"(<inertial><mass value=")" + std::to_string(mass) + R"("/><inertia )" + moments +
         R"( ixy="0" ixz="0" iyz="0"/></inertial>)";
}

std::string JointText(const std::string& name, const std::string& parent, const std::string& child,
                      const std::string& type = "floating") {
  return R"(<joint name=")" + name + R"(" type=")" + type + R"("><parent link=")" + parent + R"("/><child link=")" +
         child + "\"/></joint>\n";
}

/// Lines: 1 robot, 2 ground, 3 body, 4 joint, then what is added.
std::string FreeBody(const std::string& inertial, const std::string& more = "") {
  return kRobot + LinkText("ground") + LinkText("body", inertial) + JointText("free", "ground", "body") + more +
         "</robot>";
}

class VehicleTree : public VehicleFileTest {
 protected:
  void ExpectOnly(const std::string& text, int line, const Finding& kind, const std::vector<std::string>& words = {}) {
    EXPECT_FALSE(Read(text).has_value());
    Expect(line, kind, words);
  }
};

TEST_F(VehicleTree, ReadsAFreeBody) {
  const std::optional<Vehicle> vehicle = Read(FreeBody(Inertial(3)));
  ASSERT_TRUE(vehicle.has_value());
  EXPECT_EQ(vehicle->joints.at(0).type, Joint::Type::kFloating);
  EXPECT_EQ(vehicle->links.at(1).mass.value, 3);
}

TEST_F(VehicleTree, PutsTheGroundFirstAndParentsBeforeChildren) {
  const std::optional<Vehicle> vehicle =
      Read(kRobot + LinkText("b", Inertial(1)) + LinkText("a", Inertial(1)) + LinkText("ground") +
           JointText("second", "a", "b") + JointText("first", "ground", "a") + "</robot>");
  ASSERT_TRUE(vehicle.has_value());
  EXPECT_EQ(vehicle->links.at(0).name, "ground");
  EXPECT_EQ(vehicle->joints.at(0).name, "first");
  EXPECT_EQ(vehicle->joints.at(1).name, "second");
  EXPECT_EQ(vehicle->links.at(static_cast<std::size_t>(vehicle->joints[1].child)).name, "b");
}

std::string FreeBodies(int count, const std::string& more = "") {
  std::string text = kRobot + LinkText("ground");
  for (int i = 0; i < count; ++i) {
    const std::string body = "body" + std::to_string(i);
    text += LinkText(body, Inertial(1)) + JointText("free" + std::to_string(i), "ground", body);
  }
  return text + more + "</robot>";
}

TEST_F(VehicleTree, HasNoMoreCoordinatesThanCanBeComputed) {
  const std::string two = LinkText("a", Inertial(1)) + JointText("a", "ground", "a", "continuous") +
                          LinkText("b", Inertial(1)) + JointText("b", "ground", "b", "continuous");
  EXPECT_TRUE(Read(FreeBodies(33, two)).has_value());
  ExpectOnly(FreeBodies(33, two + LinkText("c", Inertial(1)) + JointText("c", "b", "c", "planar")), 0,
             kJointCoordinates, {"203", "200"});
}

TEST_F(VehicleTree, NeedsALink) { ExpectOnly(R"(<robot name="r"/>)", 0, kLinkNone); }

TEST_F(VehicleTree, NeedsAGround) {
  ExpectOnly(kRobot + LinkText("a", Inertial(1)) + LinkText("b", Inertial(1)) + JointText("ab", "a", "b") +
                 JointText("ba", "b", "a") + "</robot>",
             0, kGroundNone);
}

TEST_F(VehicleTree, HasOneRoot) {
  ExpectOnly(FreeBody(Inertial(1), LinkText("stray", Inertial(1))), 5, kGroundSecond, {"link 'stray'", "'ground'"});
}

TEST_F(VehicleTree, HasNoLoop) {
  const std::string loop =
      LinkText("a", Inertial(1)) + LinkText("b", Inertial(1)) + JointText("ab", "a", "b") + JointText("ba", "b", "a");
  EXPECT_FALSE(Read(FreeBody(Inertial(1), loop)).has_value());
  Expect(7, kJointLoop, {"joint 'ab'"});
  Expect(8, kJointLoop, {"joint 'ba'"});
}

TEST_F(VehicleTree, GivesALinkOneParent) {
  ExpectOnly(FreeBody(Inertial(1), JointText("again", "ground", "body")), 5, kJointTwoParents,
             {"link 'body'", "joint 'free'", "joint 'again'"});
}

TEST_F(VehicleTree, KnowsTheLinksOfJoints) {
  ExpectOnly(FreeBody(Inertial(1), LinkText("a", Inertial(1)) + JointText("j", "bodi", "a")), 6, kJointLink,
             {"joint 'j'", "link 'bodi'", "'body'"});
}

TEST_F(VehicleTree, NeedsBothEndsOfAJoint) {
  ExpectOnly(Replaced(FreeBody(Inertial(1)), R"(<child link="body"/>)", ""), 4, kTagMissing, {"joint 'free'"});
}

TEST_F(VehicleTree, KnowsTheTypesOfJoints) {
  ExpectOnly(Replaced(FreeBody(Inertial(1)), "floating", "floting"), 4, kUnknownChoice, {"'floating'"});
}

TEST_F(VehicleTree, AsksForTheLimitThatUrdfAsksFor) {
  ExpectOnly(Replaced(FreeBody(Inertial(1)), "floating", "prismatic"), 4, kJointLimit, {"joint 'free'"});
}

TEST_F(VehicleTree, KeepsTheGroundFreeOfMass) {
  ExpectOnly(Replaced(FreeBody(Inertial(1)), LinkText("ground"), LinkText("ground", Inertial(1))), 2, kGroundInertial,
             {"link 'ground'"});
}

TEST_F(VehicleTree, FindsDuplicateLinksAndJoints) {
  EXPECT_FALSE(
      Read(FreeBody(Inertial(1), LinkText("body", Inertial(1)) + JointText("free", "ground", "body"))).has_value());
  Expect(5, kNameTaken, {"link 'body'", "3"});
  Expect(6, kNameTaken, {"joint 'free'", "4"});
  Expect(6, kJointTwoParents);
}

TEST_F(VehicleTree, FindsMisspeltUrdf) {
  ExpectOnly(Replaced(Replaced(FreeBody(Inertial(1)), "<inertial>", "<inertail>"), "</inertial>", "</inertail>"), 3,
             kTagUnknown, {"link 'body'", "'inertial'"});
}

TEST_F(VehicleTree, FindsMisspeltAttributesOfUrdf) {
  ExpectOnly(FreeBody(Inertial(1, R"(ixx="1" iyy="1" izzz="1")")), 3, kAttributeUnknown,
             {"'izzz'", "link 'body'", "'izz'"});
}

TEST_F(VehicleTree, RejectsNamesThatParsersReadDifferently) {
  ExpectOnly(Replaced(FreeBody(Inertial(1)), "\"free\"", "\"fr\tee\""), 4, kNameReadDifferently);
}

TEST_F(VehicleTree, RejectsNegativeMass) { ExpectOnly(FreeBody(Inertial(-1)), 3, kNumberNegative); }

TEST_F(VehicleTree, RejectsTextForNumbers) {
  ExpectOnly(Replaced(FreeBody(Inertial(1)), R"(iyy="1")", R"(iyy="1 kg*m^2")"), 3, kNotAPlainNumber);
}

TEST_F(VehicleTree, RejectsInertiaThatNoBodyHas) {
  ExpectOnly(FreeBody(Inertial(1, R"(ixx="1" iyy="1" izz="2.1")")), 3, kInertiaImpossible, {"link 'body'"});
}

TEST_F(VehicleTree, AcceptsAFlatBody) {
  EXPECT_TRUE(Read(FreeBody(Inertial(1, R"(ixx="1" iyy="1" izz="2")"))).has_value());
}

TEST_F(VehicleTree, RejectsInertiaThatNoBodyHasAtABound) {
  const std::string text = Replaced(kSmallVehicle, R"(value="2 kg*m^2")",
                                    R"(value="2 kg*m^2" lower="1 kg*m^2" upper="5 kg*m^2" precision="1 kg*m^2")");
  ExpectOnly(text, LineOf(text, R"(<link name="body")"), kInertiaImpossibleAtBounds);
}

TEST_F(VehicleTree, RejectsInertiaWithoutMass) {
  const std::string load = LinkText("load", Inertial(1)) + JointText("weld", "body", "load", "fixed");
  ExpectOnly(FreeBody(Inertial(0), load), 3, kInertiaWithoutMass);
}

TEST_F(VehicleTree, RejectsMassTooSmallToComputeWith) {
  const auto of_mass = [](const std::string& mass) {
    return Replaced(FreeBody(Inertial(1)), "<mass value=\"" + std::to_string(1.0), "<mass value=\"" + mass);
  };
  ExpectOnly(of_mass("1e-320"), 3, kMassTooSmall, {"link 'body'"});
  EXPECT_TRUE(Read(of_mass("1e-6")).has_value());
}

TEST_F(VehicleTree, RejectsMovingLinksWithoutMass) {
  ExpectOnly(FreeBody(""), 3, kMassMissing, {"joint 'free'", "link 'body'"});
}

TEST_F(VehicleTree, AcceptsMassFurtherOut) {
  EXPECT_TRUE(
      Read(FreeBody("", LinkText("load", Inertial(1)) + JointText("weld", "body", "load", "fixed"))).has_value());
}

TEST_F(VehicleTree, PassesOverWhatUrdfHasForOthers) {
  const std::string others =
      "<collision><geometry><sphere radius=\"1\"/></geometry></collision></link>\n<material name=\"red\"><color "
      R"(rgba="1 0 0 1"/>)"
      "</material>\n<transmission name=\"t\"><actuator name=\"m\"/></transmission>\n<joint";
  EXPECT_TRUE(Read(Replaced(FreeBody(Inertial(1)), "</link>\n<joint", others)).has_value());
}

TEST_F(VehicleTree, ReadsNumbersOverSeveralLines) {
  const std::string origin = "<inertial><origin xyz=\"1\n\t2  3\"/>";
  const std::optional<Vehicle> vehicle = Read(Replaced(FreeBody(Inertial(1)), "<inertial>", origin));
  ASSERT_TRUE(vehicle.has_value());
  EXPECT_EQ(vehicle->links[1].ComAt({}), Eigen::Vector3d(1, 2, 3));
}

TEST_F(VehicleTree, TurnsInertiaIntoLinkAxes) {
  const std::string turned = Replaced(Inertial(1, R"(ixx="1" iyy="2" izz="3")"), "<inertial>",
                                      R"(<inertial><origin rpy="0 0 1.5707963267948966"/>)");
  const std::optional<Vehicle> vehicle = Read(FreeBody(turned));
  ASSERT_TRUE(vehicle.has_value());
  // A quarter turn about z swaps x and y; the sines of rounded angles leave about 1e-16.
  EXPECT_NEAR(vehicle->links[1].inertia[0].value, 2, 1e-15);
  EXPECT_NEAR(vehicle->links[1].inertia[1].value, 1, 1e-15);
  EXPECT_NEAR(vehicle->links[1].inertia[2].value, 3, 1e-15);
  EXPECT_NEAR(vehicle->links[1].inertia[3].value, 0, 1e-15);
}

}  // namespace
}  // namespace fourpost::vehicle_tree_test
