#include "identify/draft/channel_match.h"

#include <gtest/gtest.h>

#include "identify/draft/name_meaning.h"
#include "identify/study_file/channel_source_text.h"

namespace fourpost {
namespace {

TEST(NameMeaning, ReadsCornersAndPartsOfManySpellings) {
  for (const char* name : {"F_tyre_FL", "Load FL", "Radlast_VL", "wheelpan front left", "tireLF", "FzFL"}) {
    const NameMeaning meaning = MeaningOf(name);
    EXPECT_EQ(meaning.front, 1) << name;
    EXPECT_EQ(meaning.left, 1) << name;
    EXPECT_TRUE(meaning.words.contains("tyre")) << name;
  }
  // Glued to a quantity.
  EXPECT_EQ(MeaningOf("zrr").front, -1);
  EXPECT_EQ(MeaningOf("zrr").left, -1);
  EXPECT_EQ(MeaningOf("a_cg").front, 0);
  // A word that ends like a corner.
  EXPECT_EQ(MeaningOf("girl").left, 0);
}

TEST(NameMeaning, OtherPlacesHaveNothingInCommon) {
  EXPECT_EQ(Likeness(MeaningOf("a_body_FL"), MeaningOf("a_body_RL")), -1);
  EXPECT_EQ(Likeness(MeaningOf("a_body_FL"), MeaningOf("Chassis Acc LF")), 1);
  EXPECT_LT(Likeness(MeaningOf("a_body_FL"), MeaningOf("Hub Acc LF")), 1);
}

std::string Matched(const std::vector<ChannelMatch>& matches, const std::string& name) {
  for (const ChannelMatch& match : matches)
    if (match.name == name) return SourceText(match.source) + (match.IsSure() ? "" : " ?");
  return "none";
}

const std::vector<SoughtChannel> kSought = {{"a_body_front", kAcceleration}, {"F_tyre_front", kForce, true}};

TEST(ChannelMatch, OfOneSideTakesLeftAndRightTogether) {
  const std::vector<OfferedChannel> offered = {
      {"body FL", kAcceleration}, {"body FR", kAcceleration}, {"Load FL", kForce}, {"Load FR", kForce}};
  const std::vector<ChannelMatch> matches = MatchChannels(kSought, offered, false);
  EXPECT_EQ(Matched(matches, "a_body_front"), "{mean: [body FL, body FR]}");
  EXPECT_EQ(Matched(matches, "F_tyre_front"), "{sum: [Load FL, Load FR]}");
}

TEST(ChannelMatch, UnitsDecideBeforeNames) {
  EXPECT_EQ(Matched(MatchChannels(kSought, {{"a_body_front", kForce}}, true), "a_body_front"), "none");
}

TEST(ChannelMatch, MotionTurnsSignsAndFindsWhatNoNameSays) {
  const std::vector<OfferedChannel> offered = {{"a_body_front", kAcceleration}, {"ch 7", kForce}, {"ch 8", kForce}};
  const auto correlation = [](const std::string& sought, const std::string& channel) -> std::optional<double> {
    if (sought == "a_body_front") return -0.95;
    return channel == "ch 7" ? 0.97 : 0.2;
  };
  const std::vector<ChannelMatch> matches = MatchChannels(kSought, offered, true, correlation);
  EXPECT_EQ(Matched(matches, "a_body_front"), "{channel: a_body_front, sign: -1} ?");
  EXPECT_EQ(Matched(matches, "F_tyre_front"), "ch 7 ?");
}

TEST(ChannelMatch, NamesARivalThatFitsAsWell) {
  const std::vector<OfferedChannel> offered = {{"tyre front 1", kForce}, {"tyre front 2", kForce}};
  const std::vector<ChannelMatch> matches = MatchChannels(kSought, offered, true);
  ASSERT_EQ(matches.size(), 1U);
  EXPECT_EQ(matches.front().rival, "tyre front 2");
  EXPECT_FALSE(matches.front().IsSure());
}

}  // namespace
}  // namespace fourpost
