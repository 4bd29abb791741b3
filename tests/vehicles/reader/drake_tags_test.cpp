#include "vehicles/reader/drake_tags.h"

#include <array>

#include "tests/vehicles/small_vehicle.h"
#include "vehicles/reader/findings.h"
#include "vehicles/tags/findings.h"
#include "vehicles/tags/tag.h"

namespace fourpost::drake_tags_test {
namespace {

using tinyxml2::XMLElement;

/// Two bodies, three dimensions. Lines: 1 robot, 2 A, 3 B, 4 and 5 joints, then what is added.
const std::string kBodies = R"(<robot name="drake" xmlns:drake="http://drake.mit.edu">
<link name="ground"/><link name="A"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="B"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="a" type="floating"><parent link="ground"/><child link="A"/></joint>
<joint name="b" type="floating"><parent link="ground"/><child link="B"/></joint>
)";

const std::string kSpring = R"(<drake:linear_spring_damper>
<drake:linear_spring_damper_body_A name="A"/>
<drake:linear_spring_damper_p_AP value="1 2 3"/>
<drake:linear_spring_damper_body_B name="B"/>
<drake:linear_spring_damper_p_BQ value="4 5 6"/>
<drake:linear_spring_damper_free_length value="7.50"/>
<drake:linear_spring_damper_stiffness value="8e3"/>
<drake:linear_spring_damper_damping value="9"/>
</drake:linear_spring_damper>
)";

const std::string kBall = R"(<drake:ball_constraint>
<drake:ball_constraint_body_A name="A"/>
<drake:ball_constraint_p_AP value="0.1 0.2 0.3"/>
<drake:ball_constraint_body_B name="B"/>
<drake:ball_constraint_p_BQ value="0.1 0.2 0.3"/>
</drake:ball_constraint>
)";

const std::string kBushing = R"(<drake:linear_bushing_rpy>
<drake:bushing_frameA name="on_A"/>
<drake:bushing_frameC name="B"/>
<drake:bushing_torque_stiffness value="1 2 3"/>
<drake:bushing_torque_damping value="4 5 6"/>
<drake:bushing_force_stiffness value="7 8 9"/>
<drake:bushing_force_damping value="10 11 12"/>
</drake:linear_bushing_rpy>
)";

std::string Robot(const std::string& more) { return kBodies + more + "</robot>"; }

/// The tree that stands in for a text with Drake's tags.
class DrakeTags : public VehicleFileTest {
 protected:
  void Replace(const std::string& text) {
    ASSERT_EQ(document_.Parse(text.c_str()), tinyxml2::XML_SUCCESS);
    FileFaults faults(folder_ / "vehicle.urdf", diagnostics_);
    EXPECT_TRUE(ReplaceDrakeTags(*document_.RootElement(), faults));
  }

  /// As text, without the bodies.
  std::string Rest() {
    tinyxml2::XMLPrinter printer(nullptr, true);
    const XMLElement* last_joint = document_.RootElement()->LastChildElement("joint");
    for (const XMLElement* element = last_joint->NextSiblingElement(); element; element = element->NextSiblingElement())
      element->Accept(&printer);
    return printer.CStr();
  }

  const XMLElement& Made(const char* tag) { return *document_.RootElement()->FirstChildElement(tag); }

  void ExpectOnly(const std::string& text, const std::string& at, const Finding& kind,
                  const std::vector<std::string>& words = {}) {
    EXPECT_FALSE(Read(text).has_value());
    Expect(LineOf(text, at), kind, words);
  }

  tinyxml2::XMLDocument document_;
};

TEST_F(DrakeTags, MakeASpringAndADamper) {
  Replace(Robot(kSpring));
  EXPECT_EQ(Rest(), R"(<fp:frame name="drake_point_1" link="A" xyz="1 2 3"/>)"
                    R"(<fp:frame name="drake_point_2" link="B" xyz="4 5 6"/>)"
                    R"(<fp:spring name="drake_spring_1" parent="drake_point_1" child="drake_point_2">)"
                    R"(<linear stiffness="8000 N/m" free_length="7.5 m"/></fp:spring>)"
                    R"(<fp:damper name="drake_damper_1" parent="drake_point_1" child="drake_point_2">)"
                    R"(<linear rate="9 N*s/m"/></fp:damper>)");
}

TEST_F(DrakeTags, MakeABall) {
  Replace(Robot(kBall));
  EXPECT_EQ(Rest(), R"(<fp:frame name="drake_point_1" link="A" xyz="0.1 0.2 0.3"/>)"
                    R"(<fp:frame name="drake_point_2" link="B" xyz="0.1 0.2 0.3"/>)"
                    R"(<fp:ball name="drake_ball_1" parent="drake_point_1" child="drake_point_2"/>)");
}

TEST_F(DrakeTags, MakeABushing) {
  Replace(Robot(kBushing));
  EXPECT_EQ(Rest(), R"(<fp:bushing name="drake_bushing_1" parent="on_A" child="B">)"
                    R"(<translation x="7 N/m" y="8 N/m" z="9 N/m"/>)"
                    R"(<rotation x="1 N*m/rad" y="2 N*m/rad" z="3 N*m/rad"/>)"
                    R"(<translation_damping x="10 N*s/m" y="11 N*s/m" z="12 N*s/m"/>)"
                    R"(<rotation_damping x="4 N*m*s/rad" y="5 N*m*s/rad" z="6 N*m*s/rad"/></fp:bushing>)");
}

TEST_F(DrakeTags, MakeFrames) {
  Replace(Robot(R"(<frame name="on_A" link="A" rpy="0 0 1"/>)"));
  EXPECT_EQ(Rest(), R"(<fp:frame name="on_A" link="A" rpy="0 0 1" xyz="0 0 0"/>)");
}

TEST_F(DrakeTags, TakeNamesThatAreFree) {
  Replace(Robot(R"(<fp:frame name="drake_point_2" link="A" xyz="0 0 0"/>)" + kBall + kBall));
  EXPECT_NE(Rest().find(R"(name="drake_ball_1" parent="drake_point_1" child="drake_point_3")"), std::string::npos);
  EXPECT_NE(Rest().find(R"(name="drake_ball_2" parent="drake_point_4" child="drake_point_5")"), std::string::npos);
}

TEST_F(DrakeTags, KeepTheirLines) {
  const std::string text = Robot(kSpring);
  Replace(text);
  EXPECT_EQ(LineOf(Made("fp:spring")), LineOf(text, "<drake:linear_spring_damper>"));
  EXPECT_EQ(LineOf(*Made("fp:damper").FirstChildElement(), "rate"), LineOf(text, "_damping "));
  EXPECT_EQ(LineOf(Made("fp:frame"), "link"), LineOf(text, "_body_A "));
}

TEST_F(DrakeTags, MakeAVehicleWithoutAWarning) {
  const std::string text = Robot("<frame name=\"on_A\"\nlink=\"A\" xyz=\"0.5 0 0\"/>\n" + kBall +
                                 "<fp:rod name=\"r\" parent=\"on_A\" child=\"ground\"/>");
  const std::optional<Vehicle> vehicle =
      Read(Replaced(text, "xmlns:drake", "xmlns:fp=\"urn:fourpost:vehicle:1\" xmlns:drake"));
  ASSERT_TRUE(vehicle.has_value());
  EXPECT_EQ(vehicle->rods.at(0).parent.xyz, Eigen::Vector3d(0.5, 0, 0));
  const Ball& ball = vehicle->balls.at(0);
  EXPECT_EQ(ball.name, "drake_ball_1");
  EXPECT_EQ(ball.parent.link, 1);
  EXPECT_EQ(ball.child.link, 2);
  EXPECT_EQ(ball.child.xyz, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(ball.source_line, LineOf(text, "<drake:ball"));
}

TEST_F(DrakeTags, MakeForces) {
  const std::string text = Robot(
      "<frame name=\"on_A\" link=\"A\" rpy=\"0 0 1.5707963267948966\"/>\n"
      "<frame name=\"on_B\" link=\"B\" rpy=\"0 0 1.5707963267948966\"/>\n" +
      kSpring + Replaced(kBushing, R"(name="B")", R"(name="on_B")"));
  const std::optional<Vehicle> vehicle = Read(text);
  ASSERT_TRUE(vehicle.has_value());
  const Spring& spring = vehicle->springs.at(0);
  EXPECT_EQ(spring.Element(), "fp:spring 'drake_spring_1'");
  EXPECT_EQ(spring.line.child.xyz, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(spring.law.stiffness.value, 8000);
  EXPECT_EQ(spring.free_length.value_or(Scalar()).value, 7.5);
  EXPECT_EQ(spring.source_line, LineOf(text, "<drake:linear_spring_damper>"));
  EXPECT_EQ(vehicle->dampers.at(0).law.rebound.value, 9);
  const Bushing& bushing = vehicle->bushings.at(0);
  EXPECT_EQ(bushing.parent.link, 1);
  EXPECT_EQ(bushing.child.link, 2);
  // A quarter turn left: the bushing's x axis is the link's y axis, up to the rounding of the angle.
  EXPECT_NEAR(bushing.axes(1, 0), 1, 1e-15);
  const std::array<double, 6> stiffness = {7, 8, 9, 1, 2, 3};
  const std::array<double, 6> damping = {10, 11, 12, 4, 5, 6};
  for (std::size_t i = 0; i < stiffness.size(); ++i) {
    EXPECT_EQ(bushing.stiffness[i].value, stiffness[i]);
    EXPECT_EQ(bushing.damping[i].value, damping[i]);
  }
}

// A file for Drake alone does not declare our prefix.
TEST_F(DrakeTags, NeedNoNamespaceOfOurs) { EXPECT_TRUE(Read(Robot(kBall)).has_value()); }

TEST_F(DrakeTags, WarnOfThoseThatAreIgnored) {
  const std::string text = Robot(kBall + "<drake:collision_filter_group/>\n<drake:joint/>");
  EXPECT_TRUE(Read(text).has_value());
  Expect(LineOf(text, "<drake:coll"), kForeignPrefix, {"'drake:'", "ball_constraint"});
}

TEST_F(DrakeTags, WarnOfABushingThatDrakeHasUnderLoad) {
  const auto with_frame = [](const std::string& place) {
    return Robot(R"(<frame name="on_A" link="A" )" + place + "/>\n" + kBushing);
  };
  // Typed digits.
  EXPECT_TRUE(Read(with_frame(R"(xyz="0.00004 0 0" rpy="0.0004 0 0")")).has_value());
  for (const auto& [place, apart] :
       {std::pair(R"(xyz="0 0.3 0.4")", "500 mm and 0 deg"), std::pair(R"(rpy="0 0 0.1")", "0 mm and 5.7 deg")}) {
    const std::string text = with_frame(place);
    EXPECT_TRUE(Read(text).has_value());
    Expect(LineOf(text, "<drake:linear_b"), kDrakeFramesApart, {"fp:bushing 'drake_bushing_1'", apart});
  }
}

TEST_F(DrakeTags, NeedEachChild) {
  ExpectOnly(Robot(Replaced(kBall, R"(<drake:ball_constraint_p_AP value="0.1 0.2 0.3"/>)", "")), "<drake:ball_cons",
             kTagMissing);
}

TEST_F(DrakeTags, HaveEachChildOnce) {
  const std::string body = R"(<drake:ball_constraint_body_B name="B"/>)";
  ExpectOnly(Robot(Replaced(kBall, body, body + "\n<drake:ball_constraint_body_B  name=\"B\"/>")), "_body_B  ",
             kTagTwice);
}

TEST_F(DrakeTags, KnowTheirChildren) {
  const std::string text = Robot(Replaced(kSpring, "_free_length", "_fre_length"));
  EXPECT_FALSE(Read(text).has_value());
  Expect(LineOf(text, "_fre_"), kTagUnknown, {"'drake:linear_spring_damper_free_length'"});
}

TEST_F(DrakeTags, KnowTheirAttributes) {
  const std::string text = Robot(Replaced(kBushing, R"(force_damping value)", R"(force_damping vlaue)"));
  ExpectOnly(text, "vlaue", kAttributeUnknown, {"'value'"});
}

TEST_F(DrakeTags, HaveNoNames) {
  ExpectOnly(Robot(Replaced(kBall, "<drake:ball_constraint>", R"(<drake:ball_constraint name="b">)")),
             "<drake:ball_constraint ", kAttributeUnknown, {"'name'", "'b'"});
}

TEST_F(DrakeTags, NeedThreeNumbersForAPoint) {
  ExpectOnly(Robot(Replaced(kSpring, "4 5 6", "4 5")), "4 5", kNotAVector,
             {R"(value="4 5" of <drake:linear_spring_damper_p_BQ>)"});
}

TEST_F(DrakeTags, NeedPlainNumbers) { ExpectOnly(Robot(Replaced(kSpring, "8e3", "8e3 N/m")), "8e3", kNotAPlainNumber); }

TEST_F(DrakeTags, RefuseANegativeDamping) {
  ExpectOnly(Robot(Replaced(kSpring, R"("9")", R"("-9")")), R"("-9")", kNumberNegative);
}

TEST_F(DrakeTags, NeedAFreeLength) {
  ExpectOnly(Robot(Replaced(kSpring, "7.50", "0")), "_free_length", kNumberNotPositive);
}

TEST_F(DrakeTags, KnowTheLinks) {
  ExpectOnly(Robot(Replaced(kBall, R"(body_A name="A")", R"(body_A name="AB")")), "body_A", kReferenceUnknown,
             {"fp:frame 'drake_point_1'", "link 'AB'"});
}

TEST_F(DrakeTags, AreCheckedAsOurs) {
  ExpectOnly(Robot(R"(<frame name="on_A" link="A" xyz="0 0 0" rpy="0 0"/>)"), "on_A", kNotAVector,
             {R"(rpy="0 0" of fp:frame)", "'on_A'"});
}

}  // namespace
}  // namespace fourpost::drake_tags_test
