#include "identify/experiments/time_history/release_text.h"

#include <gtest/gtest.h>

namespace fourpost::release_text_test {
namespace {

TEST(ReleaseText, SaysFromWhere) {
  EXPECT_EQ(ParseRelease("estimated")->from, Release::From::kAnyState);
  EXPECT_EQ(ParseRelease(" at rest")->from, Release::From::kRest);
  const std::optional<Release> held = ParseRelease("z_body=-50 mm, z_axle = estimated");
  ASSERT_TRUE(held);
  EXPECT_EQ(held->from, Release::From::kHeld);
  ASSERT_EQ(held->held.size(), 2U);
  EXPECT_EQ(held->held[0].sensor, "z_body");
  EXPECT_DOUBLE_EQ(held->held[0].reading_m.value(), -0.05);
  EXPECT_EQ(held->held[1].sensor, "z_axle");
  EXPECT_FALSE(held->held[1].reading_m);
}

TEST(ReleaseText, IsNoOtherText) {
  for (const char* text : {"", "rest", "z_body", "z_body=", "=50 mm", "z_body=50", "z_body=50 N", "z_body=5 mm,z"})
    EXPECT_FALSE(ParseRelease(text)) << text;
}

}  // namespace
}  // namespace fourpost::release_text_test
