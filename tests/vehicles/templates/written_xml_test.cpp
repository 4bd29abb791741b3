#include "vehicles/templates/written_xml.h"

#include <gtest/gtest.h>

namespace fourpost::written_xml_test {
namespace {

TEST(WrittenXml, AttributesHoldAnyBytes) {
  EXPECT_EQ(InAttribute("a--b <&\"'>.json"), "a--b &lt;&amp;&quot;'>.json");
  EXPECT_EQ(InAttribute("\x01 \xff"), "  \xEF\xBF\xBD");
}

TEST(WrittenXml, HyphensDoNotMeetInComments) {
  EXPECT_EQ(InComment("init --load a---b <&>"), "init - -load a- - -b <&>");
  EXPECT_EQ(InComment("a-b\x1f \xc3"), "a-b  \xEF\xBF\xBD");
}

}  // namespace
}  // namespace fourpost::written_xml_test
