#include "analysis/text/nearest.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::nearest_test {
namespace {

constexpr std::array<std::string_view, 4> kLegal = {"gain", "phase", "amplitude", "channel"};

TEST(NearestName, FindsOneEditOfEachKind) {
  EXPECT_EQ(NearestName("phasd", kLegal), "phase");
  EXPECT_EQ(NearestName("phas", kLegal), "phase");
  EXPECT_EQ(NearestName("phasee", kLegal), "phase");
  EXPECT_EQ(NearestName("gian", kLegal), "gain");
}

TEST(NearestName, IgnoresCase) { EXPECT_EQ(NearestName("GAIN", kLegal), "gain"); }

TEST(NearestName, AllowsAThirdOfTheLetters) {
  EXPECT_EQ(NearestName("amplxxxde", kLegal), "amplitude");
  EXPECT_FALSE(NearestName("ampxxxxde", kLegal));
}

TEST(NearestName, IsNothingFarFromAll) {
  EXPECT_FALSE(NearestName("stiffness", kLegal));
  EXPECT_FALSE(NearestName("", kLegal));
  EXPECT_FALSE(NearestName("gain", std::span<const std::string_view>()));
}

TEST(NearestName, IsTheFirstOfEquals) {
  const std::vector<std::string> legal = {"s_FL", "s_FR"};
  EXPECT_EQ(NearestName("s_FX", legal), "s_FL");
}

TEST(NearestName, IsTheNearestAndNotTheFirst) {
  const std::vector<std::string> legal = {"strut_FL", "strut_RR"};
  EXPECT_EQ(NearestName("strut_RK", legal), "strut_RR");
}

TEST(DidYouMean, EndsAMessage) {
  EXPECT_EQ(DidYouMean("gian", kLegal), ", did you mean 'gain'?");
  EXPECT_EQ(DidYouMean("stiffness", kLegal), "");
}

TEST(DidYouMean, ListsAllWhereNoneIsNear) {
  const std::vector<std::string> legal = {"gain", "phase"};
  EXPECT_EQ(DidYouMeanOrAll("gian", legal), ", did you mean 'gain'?");
  EXPECT_EQ(DidYouMeanOrAll("stiffness", legal), "; there are gain, phase");
}

TEST(Nearest, ComparesNoNamesOfMegabytes) {
  const std::vector<std::string> names = {std::string(3'000'000, 'a'), "ab"};
  EXPECT_EQ(DidYouMean(std::string(3'000'000, 'b'), names), "");
  EXPECT_EQ(DidYouMean("abc", names), ", did you mean 'ab'?");
}

}  // namespace
}  // namespace fourpost::nearest_test
