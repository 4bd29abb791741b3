#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "tests/vehicles/small_vehicle.h"
#include "vehicles/reader/findings.h"
#include "vehicles/tags/findings.h"

namespace fourpost::parameter_likeness_test {
namespace {

/// Rates of both coils; the second one like the first.
std::string WithLike(const std::string& like, const std::string& bounds = "") {
  return Replaced(Replaced(kSmallVehicle, R"(child="ground"><linear stiffness="$k"/>)",
                           R"(child="ground"><linear stiffness="$k_helper"/>)"),
                  R"(  <fp:frame name="top")",
                  "  <fp:parameter name=\"k_helper\" value=\"9 N/mm\" " + bounds + " source=\"bench\"\n" + like +
                      "/>\n  <fp:frame name=\"top\"");
}

class ParameterLikeness : public VehicleFileTest {
 protected:
  void Refuses(const std::string& like, const Finding& kind,
               const std::string& at = "like=", const std::string& bounds = "") {
    const std::string text = WithLike(like, bounds);
    EXPECT_FALSE(Read(text).has_value());
    Expect(LineOf(text, at), kind);
  }
};

TEST_F(ParameterLikeness, NamesAParameterAndADeviation) {
  const std::optional<Vehicle> vehicle = Read(WithLike(R"(like="k" like_sd="0.2")"));
  ASSERT_TRUE(vehicle.has_value());
  EXPECT_FALSE(vehicle->parameters.at(*vehicle->IndexOf("k")).like.has_value());
  const auto& like = vehicle->parameters.at(*vehicle->IndexOf("k_helper")).like;
  ASSERT_TRUE(like.has_value());
  EXPECT_EQ(like->parameter, "k");
  EXPECT_EQ(like->sd, 0.2);
}

TEST_F(ParameterLikeness, NeedsBoth) {
  Refuses(R"(like="k")", kLikeIncomplete, "name=\"k_helper\"");
  diagnostics_ = {};
  Refuses(R"(like_sd="0.2")", kLikeIncomplete, "name=\"k_helper\"");
}

TEST_F(ParameterLikeness, NeedsAnotherParameter) {
  Refuses(R"(like="kk" like_sd="0.2")", kLikeUnknown);
  diagnostics_ = {};
  Refuses(R"(like="k_helper" like_sd="0.2")", kLikeUnknown);
}

TEST_F(ParameterLikeness, StatesARatioOnce) {
  const std::string text = Replaced(WithLike(R"(like="k" like_sd="0.2")"), R"(precision="0.01 N/mm" source="bench"/>)",
                                    R"(precision="0.01 N/mm" like="k_helper" like_sd="0.2" source="bench"/>)");
  EXPECT_FALSE(Read(text).has_value());
  Expect(LineOf(text, "like=\"k\""), kLikeEachOther, {"k"});
}

TEST_F(ParameterLikeness, NeedsOneOfTheSameKind) { Refuses(R"(like="m_body" like_sd="0.2")", kLikeOfOtherDimension); }

TEST_F(ParameterLikeness, NeedsADeviationAboveZero) { Refuses(R"(like="k" like_sd="0")", kNumberNotPositive); }

TEST_F(ParameterLikeness, NeedsPositiveParameters) {
  Refuses(R"(like="k" like_sd="0.2")", kLikeNotPositive,
          "like=", R"(lower="0 N/mm" upper="20 N/mm" precision="0.01 N/mm")");
}

}  // namespace
}  // namespace fourpost::parameter_likeness_test
