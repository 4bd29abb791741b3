#include "vehicles/tags/xml_limits.h"

#include "tests/vehicles/small_vehicle.h"

namespace fourpost {
namespace {

std::string Repeated(const std::string& text, std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

/// `depth` tags within each other.
std::string Nested(std::size_t depth) { return Repeated("<gazebo>\n", depth) + Repeated("</gazebo>", depth); }

/// The small vehicle, in whose last line but one something stands that readers of tags pass over.
std::string WithForeign(const std::string& text) { return Replaced(kSmallVehicle, "</robot>", text + "\n</robot>"); }

int ForeignLine() { return LineOf(kSmallVehicle, "</robot>"); }

class XmlLimits : public VehicleFileTest {
 protected:
  void ExpectOnly(const std::string& text, int line, const std::string& part) {
    EXPECT_FALSE(Read(text).has_value());
    Expect(Severity::kError, line, part);
  }
};

TEST_F(XmlLimits, AllowsTheDeepestTag) {
  // <robot> is the first.
  EXPECT_TRUE(Read(WithForeign(Nested(kMostXmlDepth - 1))).has_value());
}

TEST_F(XmlLimits, RefusesDeeperTags) {
  ExpectOnly(WithForeign(Nested(kMostXmlDepth)), ForeignLine() + static_cast<int>(kMostXmlDepth) - 1,
             "tags nested more than 64 deep");
}

// Far deeper than the stack of a recursive parser.
TEST_F(XmlLimits, RefusesTheDeepestFile) {
  ExpectOnly("<robot>\n" + Repeated("<a>", 5'000'000), 2, "tags nested more than 64 deep");
}

TEST_F(XmlLimits, CountsTagsThatCloseThemselves) {
  EXPECT_TRUE(Read(WithForeign(Repeated("<gazebo a='>' />", 2 * kMostXmlDepth))).has_value());
}

TEST_F(XmlLimits, PassesOverWhatIsNoTag) {
  const std::string tags = Repeated("<a>", 2 * kMostXmlDepth);
  EXPECT_TRUE(Read(WithForeign("<!--> " + tags + "--><gazebo><![CDATA[" + tags + "]]></gazebo>")).has_value());
}

TEST_F(XmlLimits, RefusesTooManyTags) {
  const std::string tags = Repeated("<gazebo/>", kMostXmlElements);
  ExpectOnly(WithForeign(tags), ForeignLine(), "more than 200000 tags");
}

TEST_F(XmlLimits, RefusesTooManyAttributes) {
  std::string tag = "<gazebo";
  for (std::size_t i = 0; i < kMostXmlAttributes; ++i) tag += " a" + std::to_string(i) + "=''";
  EXPECT_TRUE(Read(WithForeign(tag + "/>")).has_value());
  ExpectOnly(WithForeign(tag + "\nb=''/>"), ForeignLine() + 1, "a tag with more than 64 attributes");
}

TEST_F(XmlLimits, RefusesLargeFiles) {
  const std::string text = kSmallVehicle + std::string(kMostXmlBytes - kSmallVehicle.size(), ' ');
  EXPECT_TRUE(Read(text).has_value());
  ExpectOnly(text + " ", 0, "the file is larger than 16 MiB");
}

// As a pipe would give it, whose size nobody knows before.
TEST_F(XmlLimits, RefusesLargeTexts) {
  FileFaults faults(folder_ / "vehicle.urdf", diagnostics_);
  EXPECT_FALSE(IsWithinXmlLimits(std::string(kMostXmlBytes + 1, ' '), faults));
  Expect(Severity::kError, 0, "the file is larger than 16 MiB");
}

TEST_F(XmlLimits, RefusesDocumentTypes) {
  const std::string bomb =
      "?>\n<!DOCTYPE robot [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;\">]>\n<robot ";
  ExpectOnly(Replaced(kSmallVehicle, "?>\n<robot ", bomb), 2, "document types and entities are not supported");
}

TEST_F(XmlLimits, RefusesEntitiesAlone) {
  ExpectOnly(WithForeign("<!ENTITY a \"a\">"), ForeignLine(), "document types and entities are not supported");
}

TEST_F(XmlLimits, RefusesNulBytes) {
  ExpectOnly(Replaced(kSmallVehicle, "name=\"wheel_travel\"", std::string("name=\"wheel\0travel\"", 19)),
             LineOf(kSmallVehicle, "wheel_travel"), "a NUL byte");
}

// One parser reads a tag that hides others, another reads those.
TEST_F(XmlLimits, RefusesTagsHiddenInAttributes) {
  ExpectOnly(WithForeign("<gazebo>\n<:a\nx='><b><b><b>'/></gazebo>"), ForeignLine() + 2,
             "not XML: the value that begins here holds '<'");
}

TEST_F(XmlLimits, RefusesTagsHiddenInInstructions) {
  ExpectOnly(WithForeign("<?a > <b><b><b> ?>"), ForeignLine(), "not XML: '<' stands within <? ?>");
}

TEST_F(XmlLimits, RefusesBlanksBeforeATagsName) {
  ExpectOnly(WithForeign("<gazebo>< a></a></gazebo>"), ForeignLine(), "not XML: '<' begins no tag here");
}

TEST_F(XmlLimits, TellsWhereAQuoteIsMissing) {
  ExpectOnly(Replaced(kSmallVehicle, "<parent link=\"wheel\"/>", "<parent link=\"wheel/>"),
             LineOf(kSmallVehicle, "<parent link=\"wheel\"/>"), "its quote is missing");
}

TEST_F(XmlLimits, LeavesUnclosedMarkupToTheParser) {
  for (const std::string end : {"<a", "<a b='", "<!--", "<![CDATA[", "<?", "</", "<a/", "<a b='c'"}) {
    FileFaults faults(folder_ / "vehicle.urdf", diagnostics_);
    EXPECT_TRUE(IsWithinXmlLimits("<robot>" + end, faults)) << end;
  }
}

}  // namespace
}  // namespace fourpost
