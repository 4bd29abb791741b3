#include "vehicles/posts/post_motions.h"

#include <array>

#include <gmock/gmock.h>

#include "vehicles/posts/height_signals.h"

namespace fourpost::post_motions_test {
namespace {

UniformSpline Step() { return SmoothStep{.height_m = 0.02, .rise_s = 0.1, .start_s = 1}.Signal(); }

TEST(PostMotions, FollowAPatternByShares) {
  const PostMotion motion = FollowPattern(Step(), {1, -0.5});
  std::array<PostState, 2> posts;
  motion(1.05, posts);
  EXPECT_NEAR(posts[0].height, 0.01, 1e-12);
  EXPECT_EQ(posts[1].height, -0.5 * posts[0].height);
  EXPECT_EQ(posts[1].velocity, -0.5 * posts[0].velocity);
  motion(1.03, posts);
  EXPECT_NE(posts[0].acceleration, 0);
  EXPECT_EQ(posts[1].acceleration, -0.5 * posts[0].acceleration);
}

TEST(PostMotions, FollowTracksAfterTheirDelays) {
  const PostMotion motion = FollowTracks({{Step(), 0}, {Step(), 0.25}});
  std::array<PostState, 2> now;
  std::array<PostState, 2> later;
  motion(1.04, now);
  motion(1.29, later);
  EXPECT_EQ(now[1].height, 0);
  EXPECT_NEAR(later[1].height, now[0].height, 1e-12);
  EXPECT_NEAR(later[1].acceleration, now[0].acceleration, 1e-9);
}

TEST(PostMotions, TellHowFarEachPostGoes) {
  const PostMotion motion = FollowPattern(Step(), {1, -0.5});
  EXPECT_THAT(FarthestHeights(motion, 2, 0, 2, 0.01), testing::ElementsAre(0.02, -0.01));
  EXPECT_THAT(FarthestHeights(motion, 2, 0, 0.9, 0.01), testing::ElementsAre(0, 0));
}

}  // namespace
}  // namespace fourpost::post_motions_test
