#include "analysis/measured_response/stated_unit.h"

#include <gtest/gtest.h>

namespace fourpost::stated_unit_test {
namespace {

TEST(StatedUnit, NamesOneChannelOrAllThatAStarStandsFor) {
  EXPECT_TRUE((StatedUnit{"dist", "mm"}.Names("dist")));
  EXPECT_FALSE((StatedUnit{"dist", "mm"}.Names("distance")));
  EXPECT_TRUE((StatedUnit{"post_*", "mm"}.Names("post_FL")));
  EXPECT_TRUE((StatedUnit{"*_V", "mm"}.Names("FW_V")));
  EXPECT_FALSE((StatedUnit{"*_V", "mm"}.Names("FW_VA")));
}

TEST(StatedUnit, TheLastThatNamesAChannelCounts) {
  EXPECT_EQ(UnitStatedOf({{"*", "mm"}, {"F", "kN"}}, "F"), "kN");
  EXPECT_EQ(UnitStatedOf({{"*", "mm"}, {"F", "kN"}}, "x"), "mm");
  EXPECT_EQ(UnitStatedOf({{"F", "kN"}}, "x"), "");
}

}  // namespace
}  // namespace fourpost::stated_unit_test
