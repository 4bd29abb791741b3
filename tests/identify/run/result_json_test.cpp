#include "identify/run/result_json.h"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "identify/run/findings.h"
#include "identify/study/findings.h"

namespace fourpost::result_json_test {
namespace {

using Json = nlohmann::json;

FittedParameter Mass() {
  return {.name = "m", .start = 1700, .value = 1750, .lower = 1500, .upper = 2000, .sd = 20, .dimension = kMass};
}

Json ParametersOf(std::vector<FittedParameter> parameters) {
  FitResult fit;
  fit.parameters = std::move(parameters);
  return Json::parse(ResultJson({}, 1, fit, Json::object(), {}))["parameters"];
}

TEST(ResultJson, TellsPriorsAndHowFarTheFitWentFromThem) {
  FittedParameter known = Mass();
  known.prior_sd = 25;
  const Json parameters = ParametersOf({Mass(), known});
  EXPECT_FALSE(parameters[0].contains("prior"));
  const Json expected = {{"value", 1700.0}, {"sd", 25.0}, {"deviation_in_sd", 2.0}};
  EXPECT_EQ(parameters[1]["prior"], expected);
}

TEST(ResultJson, SaysWhyAParameterHasNoDeviation) {
  FittedParameter held = Mass();
  held.sd = held.lower_95 = held.upper_95 = NAN;
  held.state = ParameterState::kNoise;
  const Json parameters = ParametersOf({held});
  EXPECT_EQ(parameters[0]["state"], "noise");
  EXPECT_EQ(parameters[0]["sd"], nullptr);
  EXPECT_EQ(parameters[0]["interval_95"], Json({nullptr, nullptr}));
}

TEST(ResultJson, HasTheVerdictAndWhatWasLeftOutOfTheValidation) {
  FitFindings found;
  found.verdict.reasons.Report(kParametersAtBounds, {}, {"3", "5", "2"});
  found.conclusions.Report(kEndedWithoutDeviations, {});
  const Json result =
      Json::parse(ResultJson({}, 1, {}, {{"validation_left_out", {LeftOutJson({"fast", {}, "is clipped"})}}}, found));
  EXPECT_EQ(result["verdict"]["explains_data"], false);
  EXPECT_EQ(result["verdict"]["reasons"],
            Json::array({{{"id", "parameters-at-bounds"}, {"text", kParametersAtBounds.Message({"3", "5", "2"})}}}));
  EXPECT_EQ(result["conclusions"],
            Json::array({{{"id", "ended-without-deviations"}, {"text", kEndedWithoutDeviations.Message({})}}}));
  EXPECT_EQ(result["validation_left_out"], Json::array({{{"recording", "fast"}, {"reason", "is clipped"}}}));
  EXPECT_FALSE(Json::parse(ResultJson({}, 1, {}, Json::object(), {})).contains("validation_left_out"));
}

TEST(ResultJson, TellsHowTheSearchEndedAndAllItsSettings) {
  FitResult fit;
  fit.search.reason = "evaluations used up: 300 of 300 evaluations";
  fit.search_settings = {{"population", "20"}};
  const Json search = Json::parse(ResultJson({}, 1, fit, Json::object(), {}))["search"];
  EXPECT_EQ(search["end"], fit.search.reason);
  EXPECT_EQ(search["settings"]["population"], "20");
}

TEST(ResultJson, TellsEverySettingBesideTheMethods) {
  FitResult fit;
  fit.options.stop = {.max_evaluations = 300, .max_generations = 150};
  fit.options.candidates = {.count = 7, .separation = 0.25};
  fit.options.refine = {.max_iterations = 50, .step = 1e-5, .differences = Differences::kForward, .nearness = 0.2};
  fit.options.starts = 6;
  fit.options.deadline_s = 10;
  const Json result = Json::parse(ResultJson({}, 1, fit, Json::object(), {}));
  EXPECT_EQ(result["search"]["stop"], Json::parse(R"({"target_cost": null, "evaluations": 300, "generations": 150,
      "seconds": null, "stagnant_generations": 0, "free_generations": 1000, "on_collapse": true})"));
  EXPECT_EQ(result["search"]["candidates"], Json::parse(R"({"count": 7, "separation": 0.25})"));
  EXPECT_EQ(result["refine"], Json::parse(R"({"loss": "none", "differences": "forward", "step": 1e-5, "iterations": 50,
      "cost_tolerance": 1e-8, "step_tolerance": 1e-8, "nearness": 0.2, "agreement": 0.1})"));
  EXPECT_EQ(result["starts"]["asked"], 6);
  EXPECT_EQ(result["deadline_s"], 10);
}

TEST(ResultJson, KeepsWarnings) {
  FitFindings found;
  found.warnings.Report(kScaleNotMeasured, {"/somewhere/study.yaml", 12}, {"m_wheel", ""});
  found.warnings.Report(kFitNotConverged, {"static.csv"}, {"late"});
  found.warnings.Report(kNothingFree, {"study.yaml", 1});
  const Json result = Json::parse(ResultJson({}, 1, {}, Json::object(), found));
  const Json expected =
      Json::array({{{"id", "scale-not-measured"}, {"text", "study.yaml:12: " + kScaleNotMeasured.Message({"m_wheel", ""})}},
                   {{"id", "fit-not-converged"}, {"text", "static.csv: " + kFitNotConverged.Message({"late"})}}});
  EXPECT_EQ(result["warnings"], expected);
  EXPECT_EQ(Json::parse(ResultJson({}, 1, {}, Json::object(), {}))["warnings"], Json::array());
}

TEST(ResultJson, HasNoDeviationForWhatIsUndetermined) {
  FittedParameter open = Mass();
  open.sd = HUGE_VAL;
  const Json parameters = ParametersOf({Mass(), open});
  EXPECT_EQ(parameters[0]["sd"], 20);
  EXPECT_TRUE(parameters[1]["sd"].is_null());
}

}  // namespace
}  // namespace fourpost::result_json_test
