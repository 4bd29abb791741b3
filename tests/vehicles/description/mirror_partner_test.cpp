#include "vehicles/description/mirror_partner.h"

#include <gmock/gmock.h>

namespace fourpost::mirror_partner_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

TEST(MirrorPartner, IsTheRightOfALeft) {
  EXPECT_THAT(MirrorPartners("coil_left"), ElementsAre("coil_right"));
  EXPECT_THAT(MirrorPartners("Left coil"), ElementsAre("Right coil"));
  EXPECT_THAT(MirrorPartners("coilLeft2"), ElementsAre("coilRight2"));
  EXPECT_THAT(MirrorPartners("arm_l"), ElementsAre("arm_r"));
  EXPECT_THAT(MirrorPartners("tyre FL"), ElementsAre("tyre FR"));
  EXPECT_THAT(MirrorPartners("fp:tyre 'rl'"), ElementsAre("fp:tyre 'rr'"));
}

// In one way of writing LR is left rear, in another one nothing; RR may stand for either's partner.
TEST(MirrorPartner, KnowsBothOrdersOfAxleAndSide) {
  EXPECT_THAT(MirrorPartners("LF"), ElementsAre("RF"));
  EXPECT_THAT(MirrorPartners("LR"), ElementsAre("RR"));
}

TEST(MirrorPartner, ReplacesOneWordAtATime) {
  EXPECT_THAT(MirrorPartners("left_end_left"), UnorderedElementsAre("right_end_left", "left_end_right"));
}

TEST(MirrorPartner, LeavesPartsOfWords) {
  EXPECT_THAT(MirrorPartners("cleft"), IsEmpty());
  EXPECT_THAT(MirrorPartners("lefty"), IsEmpty());
  EXPECT_THAT(MirrorPartners("coil"), IsEmpty());
  EXPECT_THAT(MirrorPartners("FLAP"), IsEmpty());
}

TEST(MirrorPartner, IsNoneOfARight) { EXPECT_THAT(MirrorPartners("coil_right"), IsEmpty()); }

}  // namespace
}  // namespace fourpost::mirror_partner_test
