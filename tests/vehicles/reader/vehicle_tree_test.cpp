#include "tests/vehicles/small_vehicle.h"

namespace fourpost {
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
  void ExpectOnly(const std::string& text, int line, const std::string& part) {
    EXPECT_FALSE(Read(text).has_value());
    Expect(Severity::kError, line, part);
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
             "the joints have 203 coordinates, more than 200");
}

TEST_F(VehicleTree, NeedsALink) { ExpectOnly(R"(<robot name="r"/>)", 0, "there is no link"); }

TEST_F(VehicleTree, NeedsAGround) {
  ExpectOnly(kRobot + LinkText("a", Inertial(1)) + LinkText("b", Inertial(1)) + JointText("ab", "a", "b") +
                 JointText("ba", "b", "a") + "</robot>",
             0, "there is no ground");
}

TEST_F(VehicleTree, HasOneRoot) {
  ExpectOnly(FreeBody(Inertial(1), LinkText("stray", Inertial(1))), 5,
             "link 'stray' is the child of no joint: only the ground, 'ground', may be so");
}

TEST_F(VehicleTree, HasNoLoop) {
  const std::string loop =
      LinkText("a", Inertial(1)) + LinkText("b", Inertial(1)) + JointText("ab", "a", "b") + JointText("ba", "b", "a");
  EXPECT_FALSE(Read(FreeBody(Inertial(1), loop)).has_value());
  Expect(Severity::kError, 7, "joint 'ab' is part of a loop");
  Expect(Severity::kError, 8, "joint 'ba' is part of a loop");
}

TEST_F(VehicleTree, GivesALinkOneParent) {
  ExpectOnly(FreeBody(Inertial(1), JointText("again", "ground", "body")), 5,
             "link 'body' has two parents: joint 'free' and joint 'again'");
}

TEST_F(VehicleTree, KnowsTheLinksOfJoints) {
  ExpectOnly(FreeBody(Inertial(1), LinkText("a", Inertial(1)) + JointText("j", "bodi", "a")), 6,
             "joint 'j' has the unknown parent link 'bodi', did you mean 'body'?");
}

TEST_F(VehicleTree, NeedsBothEndsOfAJoint) {
  ExpectOnly(Replaced(FreeBody(Inertial(1)), R"(<child link="body"/>)", ""), 4, "joint 'free' needs a <child>");
}

TEST_F(VehicleTree, KnowsTheTypesOfJoints) {
  ExpectOnly(Replaced(FreeBody(Inertial(1)), "floating", "floting"), 4, "did you mean 'floating'?");
}

TEST_F(VehicleTree, AsksForTheLimitThatUrdfAsksFor) {
  ExpectOnly(Replaced(FreeBody(Inertial(1)), "floating", "prismatic"), 4,
             "joint 'free' is prismatic: URDF asks for a <limit");
}

TEST_F(VehicleTree, KeepsTheGroundFreeOfMass) {
  ExpectOnly(Replaced(FreeBody(Inertial(1)), LinkText("ground"), LinkText("ground", Inertial(1))), 2,
             "link 'ground' is the ground and must not have an <inertial>");
}

TEST_F(VehicleTree, FindsDuplicateLinksAndJoints) {
  EXPECT_FALSE(
      Read(FreeBody(Inertial(1), LinkText("body", Inertial(1)) + JointText("free", "ground", "body"))).has_value());
  Expect(Severity::kError, 5, "link 'body' is already defined in line 3");
  Expect(Severity::kError, 6, "joint 'free' is already defined in line 4");
  Expect(Severity::kError, 6, "has two parents");
}

TEST_F(VehicleTree, FindsMisspeltUrdf) {
  ExpectOnly(Replaced(Replaced(FreeBody(Inertial(1)), "<inertial>", "<inertail>"), "</inertial>", "</inertail>"), 3,
             "unknown tag <inertail> in link 'body', did you mean 'inertial'?");
}

TEST_F(VehicleTree, FindsMisspeltAttributesOfUrdf) {
  ExpectOnly(FreeBody(Inertial(1, R"(ixx="1" iyy="1" izzz="1")")), 3,
             "unknown attribute 'izzz' of <inertia> of <inertial> of link 'body', did you mean 'izz'?");
}

TEST_F(VehicleTree, RejectsNamesThatParsersReadDifferently) {
  ExpectOnly(Replaced(FreeBody(Inertial(1)), "\"free\"", "\"fr\tee\""), 4, "has a name that parsers read differently");
}

TEST_F(VehicleTree, RejectsNegativeMass) { ExpectOnly(FreeBody(Inertial(-1)), 3, "must not be negative"); }

TEST_F(VehicleTree, RejectsTextForNumbers) {
  ExpectOnly(Replaced(FreeBody(Inertial(1)), R"(iyy="1")", R"(iyy="1 kg*m^2")"), 3, "is not a plain number");
}

TEST_F(VehicleTree, RejectsInertiaThatNoBodyHas) {
  ExpectOnly(FreeBody(Inertial(1, R"(ixx="1" iyy="1" izz="2.1")")), 3, "link 'body' has an inertia that no body has");
}

TEST_F(VehicleTree, AcceptsAFlatBody) {
  EXPECT_TRUE(Read(FreeBody(Inertial(1, R"(ixx="1" iyy="1" izz="2")"))).has_value());
}

TEST_F(VehicleTree, RejectsInertiaThatNoBodyHasAtABound) {
  const std::string text = Replaced(kSmallVehicle, R"(value="2 kg*m^2")",
                                    R"(value="2 kg*m^2" lower="1 kg*m^2" upper="5 kg*m^2" precision="1 kg*m^2")");
  ExpectOnly(text, LineOf(text, R"(<link name="body")"), "at some of its parameters' bounds");
}

TEST_F(VehicleTree, RejectsInertiaWithoutMass) {
  const std::string load = LinkText("load", Inertial(1)) + JointText("weld", "body", "load", "fixed");
  ExpectOnly(FreeBody(Inertial(0), load), 3, "has inertia but no mass");
}

TEST_F(VehicleTree, RejectsMovingLinksWithoutMass) {
  ExpectOnly(FreeBody(""), 3, "joint 'free' moves link 'body', but neither it nor what it carries has a mass");
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
}  // namespace fourpost
