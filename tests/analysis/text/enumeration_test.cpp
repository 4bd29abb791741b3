#include "analysis/text/enumeration.h"

#include <vector>

#include <gtest/gtest.h>

namespace fourpost::enumeration_test {
namespace {

TEST(Enumeration, HasCommasAndAnAnd) {
  EXPECT_EQ(Enumeration(std::vector<std::string>{}), "");
  EXPECT_EQ(Enumeration(std::vector<std::string>{"a"}), "a");
  EXPECT_EQ(Enumeration(std::vector<std::string>{"a", "b"}), "a and b");
  EXPECT_EQ(Enumeration(std::vector<std::string>{"a", "b", "c"}), "a, b and c");
}

}  // namespace
}  // namespace fourpost::enumeration_test
