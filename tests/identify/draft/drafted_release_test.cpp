#include "identify/draft/drafted_release.h"

#include <gtest/gtest.h>

namespace fourpost::drafted_release_test {
namespace {

ChannelMatch MatchOf(const std::string& sensor, const std::string& channel) {
  return {.name = sensor, .source = {.channels = {SourceChannel(channel)}}, .correlation = {}, .rival = {}};
}

/// Two drops in ten seconds each; the body's channel is of the other sign.
class DraftedReleaseTest : public testing::Test {
 protected:
  DraftedReleaseTest() {
    matches_[1].source.channels.front().factor = -1;
    preparation_.summary.releases = {{0, 1.5, 3.55, 10}, {14, 16, 17.95, 20}};
    preparation_.summary.columns = {
        {.name = "Axle", .unit = "in", .unit_known = true, .above_rest = {1.6, 0}},
        {.name = "Body", .unit = "mm", .unit_known = true, .above_rest = {-12.5, -25.25}},
        {.name = "Acc", .unit = "g", .unit_known = true, .above_rest = {0, 0}},
    };
  }

  DraftedPreparation preparation_;
  std::vector<ChannelMatch> matches_ = {MatchOf("z_axle", "Axle"), MatchOf("z_body", "Body"), MatchOf("a_body", "Acc")};
};

TEST_F(DraftedReleaseTest, BeginsWhereTheRestIsLeftAndEndsWhenTheMotionHasDiedAway) {
  EXPECT_EQ(ReleaseLines(preparation_, matches_, 0),
            "    start: 1.5 s  # look at: the first sample that leaves its rest\n"
            "    end: 4.1 s  # the motion has died away by 3.55 s\n"
            "    release: at rest  # look at: before it Axle 40.6 mm, Body 12.5 mm above rest; if it was held there "
            "alone, which "
            "fits far faster: {z_axle: 40.6 mm}\n");
  EXPECT_EQ(
      ReleaseLines(preparation_, matches_, 1),
      "    start: 16 s  # look at: the first sample that leaves its rest\n"
      "    end: 18.5 s  # the motion has died away by 17.95 s\n"
      "    release: at rest  # look at: before it Body 25.2 mm above rest; if it was held there alone, which fits far "
      "faster: {z_body: 25.2 mm}\n");
}

TEST_F(DraftedReleaseTest, StartsNoSampleLate) {
  // A study takes the sample at `start` or the next one: of 3 kHz, the 4567th.
  preparation_.summary.releases = {{0, 4567 / 3000.0, 3, 3.5}};
  const std::string lines = ReleaseLines(preparation_, matches_, 0);
  EXPECT_EQ(lines.find("    start: 1.52233 s"), 0u) << lines;
  // The record ends before there would be something to cut off.
  EXPECT_EQ(lines.find("end:"), std::string::npos) << lines;
}

TEST_F(DraftedReleaseTest, InMotionItIsEstimated) {
  preparation_.summary.releases = {{0, 0, 3, 20}};
  EXPECT_EQ(ReleaseLines(preparation_, matches_, 0),
            "    end: 3.5 s  # the motion has died away by 3 s\n"
            "    release: estimated  # look at: no post moves, and the record begins in motion\n");
  preparation_.summary.releases.clear();
  EXPECT_NE(ReleaseLines(preparation_, matches_, 0).find("release: estimated  # look at: no post moves"),
            std::string::npos);
}

}  // namespace
}  // namespace fourpost::drafted_release_test
