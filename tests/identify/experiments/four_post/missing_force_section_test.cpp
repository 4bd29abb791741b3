#include "identify/experiments/four_post/missing_force_section.h"

#include <gmock/gmock.h>

namespace fourpost::missing_force_section_test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

std::string RemarkOf(const std::string& missing) {
  return MissingForceRemark({{"missing_force", Json::parse(missing)}});
}

TEST(MissingForceSection, SaysWhereAForceWithoutANameLies) {
  EXPECT_THAT(RemarkOf(R"({"misfit": 3, "unexplained": {"frequency_Hz": 17.8, "band_Hz": [15, 20]}})"),
              HasSubstr("lack a force that lies near 17.8 Hz (nine tenths of it from 15 to 20 Hz);"));
  EXPECT_EQ(RemarkOf(R"({"misfit": 3, "unexplained": null})"), "");
}

TEST(MissingForceSection, KnowsByTheMisfitOfAnOlderRunWhetherAForceIsBeyondNoise) {
  EXPECT_THAT(RemarkOf(R"({"misfit": 1.6})"), HasSubstr("lack a force that exceeds its noise;"));
  EXPECT_THAT(MissingForceHtml({{"missing_force", {{"misfit", 1.6}}}}, nullptr),
              HasSubstr("the force exceeds its noise, "));
  EXPECT_EQ(RemarkOf(R"({"misfit": 1.4})"), "");
  EXPECT_EQ(RemarkOf("null"), "");
}

}  // namespace
}  // namespace fourpost::missing_force_section_test
