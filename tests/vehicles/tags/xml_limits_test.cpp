#include "vehicles/tags/xml_limits.h"

#include "tests/vehicles/small_vehicle.h"
#include "vehicles/tags/findings.h"

namespace fourpost::xml_limits_test {
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
  void ExpectOnly(const std::string& text, int line, const Finding& kind, const std::vector<std::string>& words = {}) {
    EXPECT_FALSE(Read(text).has_value());
    Expect(line, kind, words);
  }
};

TEST_F(XmlLimits, AllowsTheDeepestTag) {
  // <robot> is the first.
  EXPECT_TRUE(Read(WithForeign(Nested(kMostXmlDepth - 1))).has_value());
}

TEST_F(XmlLimits, RefusesDeeperTags) {
  ExpectOnly(WithForeign(Nested(kMostXmlDepth)), ForeignLine() + static_cast<int>(kMostXmlDepth) - 1, kXmlDepth,
             {"64"});
}

// Far deeper than the stack of a recursive parser.
TEST_F(XmlLimits, RefusesTheDeepestFile) { ExpectOnly("<robot>\n" + Repeated("<a>", 5'000'000), 2, kXmlDepth, {"64"}); }

TEST_F(XmlLimits, CountsTagsThatCloseThemselves) {
  EXPECT_TRUE(Read(WithForeign(Repeated("<gazebo a='>' />", 2 * kMostXmlDepth))).has_value());
}

TEST_F(XmlLimits, PassesOverWhatIsNoTag) {
  const std::string tags = Repeated("<a>", 2 * kMostXmlDepth);
  EXPECT_TRUE(Read(WithForeign("<!--> " + tags + "--><gazebo><![CDATA[" + tags + "]]></gazebo>")).has_value());
}

TEST_F(XmlLimits, RefusesTooManyTags) {
  const std::string tags = Repeated("<gazebo/>", kMostXmlElements);
  ExpectOnly(WithForeign(tags), ForeignLine(), kXmlTags, {"200000"});
}

TEST_F(XmlLimits, RefusesTooManyAttributes) {
  std::string tag = "<gazebo";
  for (std::size_t i = 0; i < kMostXmlAttributes; ++i) tag += " a" + std::to_string(i) + "=''";
  EXPECT_TRUE(Read(WithForeign(tag + "/>")).has_value());
  ExpectOnly(WithForeign(tag + "\nb=''/>"), ForeignLine() + 1, kXmlAttributes, {"64"});
}

TEST_F(XmlLimits, RefusesLargeFiles) {
  const std::string text = kSmallVehicle + std::string(kMostXmlBytes - kSmallVehicle.size(), ' ');
  EXPECT_TRUE(Read(text).has_value());
  ExpectOnly(text + " ", 0, kXmlFileTooLarge, {"16 MiB"});
}

// As a pipe would give it, whose size nobody knows before.
TEST_F(XmlLimits, RefusesLargeTexts) {
  FileFaults faults(folder_ / "vehicle.urdf", diagnostics_);
  EXPECT_FALSE(IsWithinXmlLimits(std::string(kMostXmlBytes + 1, ' '), faults));
  Expect(0, kXmlFileTooLarge, {"16 MiB"});
}

TEST_F(XmlLimits, RefusesDocumentTypes) {
  const std::string bomb =
      "?>\n<!DOCTYPE robot [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;\">]>\n<robot ";
  ExpectOnly(Replaced(kSmallVehicle, "?>\n<robot ", bomb), 2, kXmlDocumentType);
}

TEST_F(XmlLimits, RefusesEntitiesAlone) {
  ExpectOnly(WithForeign("<!ENTITY a \"a\">"), ForeignLine(), kXmlDocumentType);
}

TEST_F(XmlLimits, RefusesNulBytes) {
  ExpectOnly(Replaced(kSmallVehicle, "name=\"wheel_travel\"", std::string("name=\"wheel\0travel\"", 19)),
             LineOf(kSmallVehicle, "wheel_travel"), kXmlNul);
}

// One parser reads a tag that hides others, another reads those.
TEST_F(XmlLimits, RefusesTagsHiddenInAttributes) {
  ExpectOnly(WithForeign("<gazebo>\n<:a\nx='><b><b><b>'/></gazebo>"), ForeignLine() + 2, kXmlOpenQuote, {"'<'"});
}

TEST_F(XmlLimits, RefusesTagsHiddenInInstructions) {
  ExpectOnly(WithForeign("<?a > <b><b><b> ?>"), ForeignLine(), kXmlInstruction, {"'<'"});
}

TEST_F(XmlLimits, RefusesBlanksBeforeATagsName) {
  ExpectOnly(WithForeign("<gazebo>< a></a></gazebo>"), ForeignLine(), kXmlStrayBracket, {"'<'"});
}

TEST_F(XmlLimits, TellsWhereAQuoteIsMissing) {
  ExpectOnly(Replaced(kSmallVehicle, "<parent link=\"wheel\"/>", "<parent link=\"wheel/>"),
             LineOf(kSmallVehicle, "<parent link=\"wheel\"/>"), kXmlOpenQuote);
}

TEST_F(XmlLimits, LeavesUnclosedMarkupToTheParser) {
  for (const std::string end : {"<a", "<a b='", "<!--", "<![CDATA[", "<?", "</", "<a/", "<a b='c'"}) {
    FileFaults faults(folder_ / "vehicle.urdf", diagnostics_);
    EXPECT_TRUE(IsWithinXmlLimits("<robot>" + end, faults)) << end;
  }
}

}  // namespace
}  // namespace fourpost::xml_limits_test
