#include "identify/suggest/vehicle_edit.h"

#include <gmock/gmock.h>

namespace fourpost::vehicle_edit_test {
namespace {

constexpr const char* kText = R"(<?xml version="1.0"?>
<!-- a > comment -->
<robot name="r">
  <fp:mirror from="_left" to="_right"/>
  <fp:damper name="d" parent="a"
             child="b">
    <bilinear bump="2*$c"   rebound="$r"/>
  </fp:damper>
  <fp:tyre name="t" stiffness="1 N/m"/>
</robot>
)";

class VehicleEdits : public testing::Test {
 protected:
  static std::string Replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  }

  const std::string text_ = kText;
  VehicleEdit edit_{text_};
};

TEST_F(VehicleEdits, LeaveAllElseAsItIs) { EXPECT_EQ(edit_.Text(), text_); }

TEST_F(VehicleEdits, SetAttributes) {
  const tinyxml2::XMLElement& tyre = *edit_.Find("fp:tyre", "t");
  edit_.Set(tyre, "stiffness", "2 N/m");
  edit_.Set(tyre, "damping", "$ct");
  EXPECT_EQ(edit_.Text(), Replaced(text_, R"(stiffness="1 N/m"/>)", R"(stiffness="2 N/m" damping="$ct"/>)"));
}

TEST_F(VehicleEdits, AddAChildAndTakeOneOut) {
  const tinyxml2::XMLElement& damper = *edit_.Find("fp:damper", "d");
  edit_.AddChild(damper, "<linear/>");
  edit_.Remove(*damper.FirstChildElement("bilinear"));
  EXPECT_EQ(edit_.Text(), Replaced(Replaced(text_, R"(child="b">)", "child=\"b\">\n    <linear/>"),
                                   R"(<bilinear bump="2*$c"   rebound="$r"/>)", ""));
}

TEST_F(VehicleEdits, TakeOutAnElementWithItsChildren) {
  edit_.Remove(*edit_.Find("fp:damper", "d"));
  const std::size_t begin = text_.find("<fp:damper");
  const std::string closing = "</fp:damper>";
  const std::size_t end = text_.find(closing) + closing.size();
  EXPECT_EQ(edit_.Text(), text_.substr(0, begin) + text_.substr(end));
}

TEST(VehicleEditOfComments, TakesNoTagInThemForAnEnd) {
  const std::string text =
      "<robot name=\"r\"><a name=\"x\"><!-- </a> > --><b><c/></b ><!-- </a> --></a ><a name=\"y\"/></robot>";
  VehicleEdit edit(text);
  edit.Remove(*edit.Find("a", "x"));
  EXPECT_EQ(edit.Text(), "<robot name=\"r\"><a name=\"y\"/></robot>");
}

// Both at one place of the text, in either order.
TEST(VehicleEditOfCompactText, AddsAChildWhereOneIsTakenOut) {
  const std::string text = R"(<robot name="r"><fp:damper name="d"><linear rate="1"/></fp:damper></robot>)";
  for (const bool is_added_first : {true, false}) {
    VehicleEdit edit(text);
    const tinyxml2::XMLElement& damper = *edit.Find("fp:damper", "d");
    if (is_added_first) edit.AddChild(damper, "<x/>");
    edit.Remove(*damper.FirstChildElement());
    if (!is_added_first) edit.AddChild(damper, "<x/>");
    EXPECT_EQ(edit.Text(), "<robot name=\"r\"><fp:damper name=\"d\">\n    <x/></fp:damper></robot>");
  }
}

TEST_F(VehicleEdits, OpenAnElementThatWasClosed) {
  edit_.AddChild(*edit_.Find("fp:tyre", "t"), "<x/>");
  EXPECT_EQ(edit_.Text(), Replaced(text_, R"("1 N/m"/>)", "\"1 N/m\">\n    <x/>\n  </fp:tyre>"));
}

TEST_F(VehicleEdits, RenameAnElement) {
  edit_.Rename(*edit_.Find("fp:damper", "d")->FirstChildElement("bilinear"), "digressive");
  EXPECT_EQ(edit_.Text(), Replaced(text_, "<bilinear", "<digressive"));
}

TEST_F(VehicleEdits, AddParametersInSiUnits) {
  edit_.Add({.name = "p", .dimension = kForce, .lower = 0, .upper = 200, .source = "of the test"}, 12.3456789);
  EXPECT_THAT(edit_.Text(),
              testing::HasSubstr(R"(<fp:parameter name="p" value="12.3457 N" lower="0 N" upper="200 N")"));
  EXPECT_TRUE(edit_.Text().ends_with("</robot>\n"));
}

TEST_F(VehicleEdits, KnowMirrors) {
  EXPECT_THAT(edit_.Mirrors(), testing::ElementsAre(testing::Pair("_left", "_right")));
  EXPECT_EQ(edit_.Find("fp:damper", "none"), nullptr);
}

}  // namespace
}  // namespace fourpost::vehicle_edit_test
