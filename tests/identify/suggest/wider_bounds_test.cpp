#include "identify/suggest/wider_bounds.h"

#include <gtest/gtest.h>

namespace fourpost::wider_bounds_test {
namespace {

std::string File(const std::string& of_speed, const std::string& of_force) {
  return "<robot name=\"car\">\n  <fp:parameter name=\"v\" value=\"0.1 m/s\" " + of_speed +
         " source=\"suggested: knee\"/>\n  <fp:parameter name=\"f\" value=\"5 N\" " + of_force +
         " source=\"suggested: friction\"/>\n  <fp:parameter name=\"c\" value=\"5 kg\" lower=\"1 kg\" upper=\"9 kg\" "
         "source=\"catalogue\"/>\n</robot>\n";
}

constexpr const char* kSpeed = "lower=\"0.0125 m/s\" upper=\"0.2 m/s\"";
constexpr const char* kForce = "lower=\"0 N\" upper=\"50 N\"";

TEST(WiderBounds, AreThoseThatASuggestionGuessed) {
  EXPECT_EQ(WithWiderBounds(File(kSpeed, kForce), {{"v", "lower"}, {"f", "upper"}}),
            File("lower=\"0.00125 m/s\" upper=\"0.2 m/s\"", "lower=\"0 N\" upper=\"500 N\""));
}

TEST(WiderBounds, AreNotThoseOfAUserNorZero) {
  EXPECT_EQ(WithWiderBounds(File(kSpeed, kForce), {{"c", "lower"}}), std::nullopt);
  EXPECT_EQ(WithWiderBounds(File(kSpeed, kForce), {{"f", "lower"}}), std::nullopt);
  EXPECT_EQ(WithWiderBounds(File(kSpeed, kForce), {}), std::nullopt);
}

}  // namespace
}  // namespace fourpost::wider_bounds_test
