#include "analysis/measured_response/posts_by_name.h"

#include <gmock/gmock.h>

namespace fourpost::posts_by_name_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// "FL=Zyl VL FR=Zyl VR"
std::string Posts(const std::vector<std::string>& names) {
  std::string text;
  for (const PostChannel& post : PostsByName(names).posts)
    text += (text.empty() ? "" : " ") + post.post + "=" + post.channel;
  return text;
}

TEST(PostsByName, AreThoseThatSayPostOrAPlaceAlone) {
  EXPECT_EQ(Posts({"z_body", "post_FL", "Post front", "FR"}), "FL=post_FL front=Post front");
  EXPECT_EQ(Posts({"z_body", "FL", "rear", "ram FR"}), "FL=FL rear=rear");
  EXPECT_EQ(Posts({"post"}), "post=post");
  EXPECT_EQ(Posts({"post_left_1", "post_left_2"}), "left_1=post_left_1 left_2=post_left_2");
  EXPECT_TRUE(PostsByName({"post_FL", "FR"}).InWords().empty());
}

TEST(PostsByName, AreThoseThatMeanOne) {
  EXPECT_EQ(Posts({"Zyl VL", "Zyl HR", "Federweg VL"}), "FL=Zyl VL RR=Zyl HR");
  EXPECT_EQ(Posts({"actuator v", "actuator h"}), "front=actuator v rear=actuator h");
  EXPECT_EQ(Posts({"ram 1", "ram 2"}), "ram 1=ram 1 ram 2=ram 2");
  EXPECT_EQ(Posts({"act_FL", "act_FR"}), "FL=act_FL FR=act_FR");
  EXPECT_EQ(Posts({"z_road_FL", "z_road_FR"}), "FL=z_road_FL FR=z_road_FR");
  EXPECT_THAT(PostsByName({"Zyl VL", "z"}).InWords(), testing::HasSubstr("'Zyl VL' is FL"));
}

// Lasers measure the way to the ground, and "act" is short for actual.
TEST(PostsByName, AreNotPartsOfAVehicle) {
  for (const char* name : {"ride height to ground FL", "ground clearance FL", "ground FL", "damper_FL_act",
                           "strut cylinder FL", "body ram FL", "height above road FL", "damper travel FL"})
    EXPECT_EQ(Posts({name}), "") << name;
  EXPECT_EQ(Posts({"ram FL", "ground clearance FL"}), "FL=ram FL");
  EXPECT_EQ(Posts({"ram FL", "ram FR", "steering cylinder"}), "FL=ram FL FR=ram FR");
}

TEST(PostsByName, AreMeasuredNotCommanded) {
  for (const auto& [command, feedback] :
       std::vector<std::pair<std::string, std::string>>{{"Zyl_VL_soll", "Zyl_VL_ist"},
                                                        {"cyl_FL_cmd", "cyl_FL_fbk"},
                                                        {"ZylVLSoll", "ZylVLIst"},
                                                        {"ram FL drive", "ram FL"},
                                                        {"act_FL_ref", "act_FL_meas"},
                                                        {"cyl_FL_cmd", "cyl_FL_act"},
                                                        {"post_FL_cmd", "post_FL"},
                                                        {"post_FL_soll", "post_FL_ist"}}) {
    for (const std::vector<std::string>& names :
         {std::vector<std::string>{command, feedback}, std::vector<std::string>{feedback, command}}) {
      EXPECT_EQ(Posts(names), "FL=" + feedback);
      EXPECT_THAT(PostsByName(names).commands, ElementsAre(command));
      EXPECT_THAT(PostsByName(names).alike, IsEmpty());
      EXPECT_THAT(PostsByName(names).InWords(), testing::HasSubstr("commands are left out: '" + command + "'"));
    }
  }
  // A command alone is better than no post.
  EXPECT_EQ(Posts({"Zyl_VL_soll", "Zyl_VR_soll"}), "FL=Zyl_VL_soll FR=Zyl_VR_soll");
}

TEST(PostsByName, OfOnePlaceAreNotTwo) {
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"ram FL", "cyl FL"}, std::vector<std::string>{"Zyl VL 1", "Zyl VL 2"},
        std::vector<std::string>{"ram FL", "ram FL meas"}}) {
    const NamedPosts posts = PostsByName(names);
    ASSERT_EQ(posts.alike.size(), 1U);
    EXPECT_EQ(posts.alike.front(), names);
  }
}

TEST(NearlyPost, IsAPostThatIsMissing) {
  const std::vector<std::string> three = {"post_FL", "post_FR", "post_RL"};
  EXPECT_EQ(NearlyPost("psot_RR", three), "post_RR");
  EXPECT_EQ(NearlyPost("Post_RRR", three), "post_RR");
  EXPECT_EQ(NearlyPost("Zyl_HRR", {"Zyl_VL", "Zyl_VR", "Zyl_HL"}), "Zyl_HR");
  EXPECT_EQ(NearlyPost("post_reer", {"post_front"}), "post_rear");
}

TEST(NearlyPost, IsNoOther) {
  EXPECT_EQ(NearlyPost("table", {"post_FL", "post_FR", "post_RL"}), "");
  EXPECT_EQ(NearlyPost("Pot_Susp_RR", {"post_FL", "post_FR", "post_RL"}), "");
  EXPECT_EQ(NearlyPost("psot", {"post"}), "");
  EXPECT_EQ(NearlyPost("psot_RR", {}), "");
}

}  // namespace
}  // namespace fourpost::posts_by_name_test
