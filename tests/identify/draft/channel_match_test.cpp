#include "identify/draft/channel_match.h"

#include <gtest/gtest.h>

#include "analysis/text/name_meaning.h"
#include "identify/study_file/channel_source_text.h"

namespace fourpost::channel_match_test {
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

TEST(NameMeaning, ReadsItalianFrenchAndSpanish) {
  const auto part = [](const char* name) { return MeaningOf(name).words; };
  using Words = std::set<std::string>;
  for (const char* name : {"Pos_attuatore", "Pistone", "Course vérin", "Actionneur", "Cilindro", "actuador"})
    EXPECT_EQ(part(name), Words{"post"}) << name;
  for (const char* name : {"Acc_cassa", "Caisse", "Carrocería", "Châssis"})
    EXPECT_EQ(part(name), Words{"body"}) << name;
  for (const char* name : {"Acc_mozzo", "ruota", "Roue", "moyeu", "rueda", "Buje"})
    EXPECT_EQ(part(name), Words{"axle"}) << name;
  for (const char* name :
       {"Corsa_ammortizzatore", "Débattement", "DÉBATTEMENT", "recorrido amortiguador", "Dämpfer", "DÄMPFER"})
    EXPECT_EQ(part(name), Words{"strut"}) << name;
  for (const char* name : {"Carico", "Charge", "carga", "Neumático"}) EXPECT_EQ(part(name), Words{"tyre"}) << name;
  for (const char* name : {"cassa anteriore sinistra", "Caisse avant gauche", "carrocería delantera izquierda"}) {
    EXPECT_EQ(MeaningOf(name).front, 1) << name;
    EXPECT_EQ(MeaningOf(name).left, 1) << name;
  }
  for (const char* name : {"cassa posteriore destra", "Caisse arrière droite", "carrocería trasera derecha"}) {
    EXPECT_EQ(MeaningOf(name).front, -1) << name;
    EXPECT_EQ(MeaningOf(name).left, -1) << name;
  }
  EXPECT_EQ(part("Forza"), Words{});
}

TEST(NameMeaning, ReadsLettersByOthersOfTheirKind) {
  const auto places = [](const std::vector<std::string>& names, bool has_sides) {
    std::string text;
    for (const NameMeaning& meaning : MeaningsOf(names, has_sides))
      text += std::string(meaning.front > 0   ? "F"
                          : meaning.front < 0 ? "R"
                                              : "") +
              (meaning.left > 0   ? "l"
               : meaning.left < 0 ? "r"
                                  : "") +
              " ";
    return text;
  };
  EXPECT_EQ(places({"pot_F", "pot_R"}, true), "F R ");
  EXPECT_EQ(places({"pot_L", "pot_R"}, true), "l r ");
  EXPECT_EQ(places({"Weg v", "Weg h", "z_body"}, true), "F R  ");
  EXPECT_EQ(places({"pot_V_L", "pot_V_R", "pot_H_L", "pot_H_R"}, true), "Fl Fr Rl Rr ");
  EXPECT_EQ(places({"pot_Li", "pot_Re"}, true), "l r ");
  EXPECT_EQ(places({"pot_Fr", "pot_Re"}, true), "F R ");
  EXPECT_EQ(places({"pot_FL", "pot_FR", "pot_RL", "pot_RR"}, true), "Fl Fr Rl Rr ");
  EXPECT_EQ(places({"corsa_sx", "corsa_dx", "dx"}, true), "l r  ");
  EXPECT_EQ(places({"verin AV", "verin AR"}, true), "F R ");
  // Alone: right or rear?
  EXPECT_EQ(places({"post_r"}, true), " ");
  EXPECT_EQ(places({"post_r", "acc_v"}, false), "R  ");
  // A force is no place.
  EXPECT_EQ(places({"F", "F_tyre", "R_tyre"}, true), " F R ");
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

TEST(ChannelMatch, TakesFrontAndRearOfOneKindTogether) {
  const std::vector<SoughtChannel> posts = {{"post_front", kLength}, {"post_rear", kLength}};
  const std::vector<ChannelMatch> short_names = MatchChannels(posts, {{"post_r", kLength}, {"post_f", kLength}}, false);
  EXPECT_EQ(Matched(short_names, "post_front"), "post_f");
  EXPECT_EQ(Matched(short_names, "post_rear"), "post_r");
  const std::vector<SoughtChannel> struts = {{"s_strut_front", kLength}, {"s_strut_rear", kLength}};
  const std::vector<ChannelMatch> pots = MatchChannels(struts, {{"pot_R", kLength}, {"pot_F", kLength}}, false);
  EXPECT_EQ(Matched(pots, "s_strut_front"), "pot_F");
  EXPECT_EQ(Matched(pots, "s_strut_rear"), "pot_R");
}

TEST(ChannelMatch, TakesWhatIsLeftOfAKindThatMotionFound) {
  const std::vector<SoughtChannel> struts = {{"s_strut_front", kLength}, {"s_strut_rear", kLength}};
  const auto correlation = [](const std::string& sought, const std::string& channel) -> std::optional<double> {
    if (sought == "s_strut_front") return channel == "XY_F" ? 0.95 : 0.1;
    return channel == "XY_F" ? 0.2 : 0.8;
  };
  const std::vector<ChannelMatch> matches =
      MatchChannels(struts, {{"XY_F", kLength}, {"XY_R", kLength}, {"other_R", kLength}}, false, correlation);
  EXPECT_EQ(Matched(matches, "s_strut_front"), "XY_F ?");
  EXPECT_EQ(Matched(matches, "s_strut_rear"), "XY_R ?");
  EXPECT_EQ(matches.back().by, ChannelMatch::By::kKind);
}

TEST(ChannelMatch, TakesTheLastOfItsUnitThatMovesAboutSo) {
  const std::vector<OfferedChannel> offered = {{"body front", kAcceleration}, {"ch 7", kForce}};
  const auto by_motion = [&](double of_force, const std::vector<OfferedChannel>& channels) {
    return Matched(MatchChannels(kSought, channels, true,
                                 [&](const std::string&, const std::string& channel) -> std::optional<double> {
                                   return channel == "body front" ? 0.97 : of_force;
                                 }),
                   "F_tyre_front");
  };
  EXPECT_EQ(by_motion(0.86, offered), "ch 7 ?");
  EXPECT_EQ(by_motion(-0.86, offered), "{channel: ch 7, sign: -1} ?");
  EXPECT_EQ(by_motion(0.3, offered), "none");
  // Two are left, or one that means another part or stands at another place.
  EXPECT_EQ(by_motion(0.86, {{"ch 7", kForce}, {"ch 8", kForce}}), "none");
  EXPECT_EQ(by_motion(0.86, {{"Damper force", kForce}}), "none");
  EXPECT_EQ(by_motion(0.86, {{"ch 7 rear", kForce}}), "none");
}

std::vector<ChannelMatch> PostsOf(const std::vector<OfferedChannel>& offered) {
  std::vector<SoughtChannel> posts;
  for (const char* corner : {"FL", "FR", "RL", "RR"})
    posts.push_back({.name = std::string("post_") + corner, .dimension = kLength, .is_post = true});
  return MatchChannels(posts, offered, true);
}

TEST(ChannelMatch, WhatMeansAnotherPartIsNoPost) {
  for (const char* other : {"Pot_Susp_RR", "Wheel disp RR", "z_body_RR", "Tyre deflection RR"}) {
    const std::vector<ChannelMatch> matches =
        PostsOf({{"Ram_FL", kLength}, {"Ram_FR", kLength}, {"Ram_RL", kLength}, {other, kLength}});
    EXPECT_EQ(matches.size(), 3U) << other;
    EXPECT_EQ(Matched(matches, "post_RR"), "none") << other;
  }
  // One that says post as well is one, and so is what is named as the vehicle names it.
  EXPECT_EQ(Matched(PostsOf({{"Wheel_Actuator_RR", kLength}}), "post_RR"), "Wheel_Actuator_RR");
  const std::vector<SoughtChannel> by_wheel = {{.name = "post_wheel_RR", .dimension = kLength, .is_post = true}};
  EXPECT_EQ(Matched(MatchChannels(by_wheel, {{"Wheel_RR", kLength}}, true), "post_wheel_RR"), "Wheel_RR ?");
}

TEST(ChannelMatch, APostByItsPlaceAloneIsToBeLookedAt) {
  EXPECT_EQ(Matched(PostsOf({{"disp RR", kLength}}), "post_RR"), "disp RR ?");
  EXPECT_EQ(Matched(PostsOf({{"wheelpan RR", kLength}}), "post_RR"), "wheelpan RR ?");
  EXPECT_EQ(Matched(PostsOf({{"Ram RR", kLength}}), "post_RR"), "Ram RR");
}

TEST(ChannelMatch, NamesARivalThatFitsAsWell) {
  const std::vector<OfferedChannel> offered = {{"tyre front 1", kForce}, {"tyre front 2", kForce}};
  const std::vector<ChannelMatch> matches = MatchChannels(kSought, offered, true);
  ASSERT_EQ(matches.size(), 1U);
  EXPECT_EQ(matches.front().rival, "tyre front 2");
  EXPECT_FALSE(matches.front().IsSure());
}

}  // namespace
}  // namespace fourpost::channel_match_test
