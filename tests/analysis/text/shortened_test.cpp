#include "analysis/text/shortened.h"

#include <gtest/gtest.h>

namespace fourpost::shortened_test {
namespace {

TEST(Shortened, LeavesWhatIsShort) {
  EXPECT_EQ(Shortened("", 3), "");
  EXPECT_EQ(Shortened("abc", 3), "abc");
}

TEST(Shortened, KeepsBeginningAndEnd) {
  EXPECT_EQ(Shortened("aaaaaabbbbbbbbbbccc", 9), "aaaaaa[... 10 bytes ...]ccc");
  EXPECT_LT(Shortened(std::string(5'000'000, 'x'), 100).size(), 130u);
}

TEST(Shortened, CutsNoCharacter) { EXPECT_EQ(Shortened("aßßßßßßßßßße", 6), "aß[... 18 bytes ...]e"); }

}  // namespace
}  // namespace fourpost::shortened_test
