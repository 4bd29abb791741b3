#include "identify/suggest/addition.h"

#include <gtest/gtest.h>

namespace fourpost::addition_test {
namespace {

TEST(Addition, OfOneSideIsAPartOfThatOfBoth) {
  const Addition left{.mechanism = "friction", .elements = {"FL"}, .words = ""};
  const Addition both{.mechanism = "friction", .elements = {"FL", "FR"}, .words = ""};
  const Addition rear{.mechanism = "friction", .elements = {"RL"}, .words = ""};
  const Addition mounts{.mechanism = "mount", .elements = {"FL", "FR"}, .words = ""};
  EXPECT_TRUE(left.IsPartOf(both));
  EXPECT_FALSE(both.IsPartOf(left));
  EXPECT_FALSE(both.IsPartOf(both));
  EXPECT_FALSE(rear.IsPartOf(both));
  EXPECT_FALSE(left.IsPartOf(mounts));
}

}  // namespace
}  // namespace fourpost::addition_test
