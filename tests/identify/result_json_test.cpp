#include "identify/result_json.h"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace fourpost {
namespace {

using Json = nlohmann::json;

FittedParameter Mass() {
  return {.name = "m", .start = 1700, .value = 1750, .lower = 1500, .upper = 2000, .sd = 20, .dimension = kMass};
}

Json ParametersOf(std::vector<FittedParameter> parameters) {
  FitResult fit;
  fit.parameters = std::move(parameters);
  return Json::parse(ResultJson({}, 1, fit, {}, {}))["parameters"];
}

TEST(ResultJson, TellsPriorsAndHowFarTheFitWentFromThem) {
  FittedParameter known = Mass();
  known.prior_sd = 25;
  const Json parameters = ParametersOf({Mass(), known});
  EXPECT_FALSE(parameters[0].contains("prior"));
  const Json expected = {{"value", 1700.0}, {"sd", 25.0}, {"deviation_in_sd", 2.0}};
  EXPECT_EQ(parameters[1]["prior"], expected);
}

TEST(ResultJson, TellsHowTheSearchEndedAndAllItsSettings) {
  FitResult fit;
  fit.search.reason = "evaluations used up: 300 of 300 evaluations";
  fit.search_settings = {{"population", "20"}};
  const Json search = Json::parse(ResultJson({}, 1, fit, {}, {}))["search"];
  EXPECT_EQ(search["end"], fit.search.reason);
  EXPECT_EQ(search["settings"]["population"], "20");
}

TEST(ResultJson, HasNoDeviationForWhatIsUndetermined) {
  FittedParameter open = Mass();
  open.sd = HUGE_VAL;
  const Json parameters = ParametersOf({Mass(), open});
  EXPECT_EQ(parameters[0]["sd"], 20);
  EXPECT_TRUE(parameters[1]["sd"].is_null());
}

}  // namespace
}  // namespace fourpost
