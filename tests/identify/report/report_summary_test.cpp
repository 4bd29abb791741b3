#include "identify/report/report_summary.h"

#include <cmath>

#include <gmock/gmock.h>

#include "identify/study/experiment_kinds.h"
#include "vehicles/requests/versions.h"

namespace fourpost::report_summary_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

Json Good() {
  return Json::parse(R"({
    "termination": "converged", "starts": {"refined": 5, "agreeing": 5},
    "identifiability": {"rank": 2, "parameters": 2, "sd_inflation": 1.05, "weakest": ["m +1 %"]},
    "channels": [{"name": "a_body", "rms_dB": 0.5, "rms_deg": 4}, {"name": "s_strut", "rms_dB": 3.2, "rms_deg": 9}],
    "static_loads": [{"tyre": "front"}]})");
}

std::vector<ReportedParameter> Known() {
  return {{.name = "m", .value = 100, .lower = 50, .upper = 150, .sd = 1},
          {.name = "k", .value = 10, .lower = 5, .upper = 15, .sd = 0.5}};
}

/// With the remarks of all kinds of experiments.
std::string SummaryOf(const Json& result, const std::vector<ReportedParameter>& parameters,
                      std::map<std::string, std::string> files = {}) {
  const RunContents contents{.files = std::move(files)};
  ReportRemarks remarks;
  for (const ExperimentReport* experiment : AllExperimentReports())
    AddRemarks(experiment->Read({"", contents, result})->Remarks(), remarks);
  return SummaryHtml(result, OverviewOf(result), parameters, remarks);
}

TEST(Summary, TellsWhatFitsAndWhatDoesNot) {
  const std::string text = SummaryOf(Good(), Known());
  EXPECT_THAT(text, AllOf(HasSubstr("verdict fair"), HasSubstr("The fit converged."), HasSubstr("5 of 5 refinements"),
                          HasSubstr("<code>a_body</code> is within 1 dB"),
                          HasSubstr("Poor: <code>s_strut</code> (3.2 dB, 9.0\u00b0)"),
                          HasSubstr("2 of 2 parameters are determined, 1 of them within 2 %")));
  EXPECT_THAT(text, Not(HasSubstr("NMSE")));
}

// Deviations of a robust loss are not inflated, the misfit is what it is.
TEST(Summary, TellsTheMisfitWhateverTheLoss) {
  Json result = Good();
  EXPECT_THAT(SummaryOf(result, Known()), HasSubstr("explain the residuals"));
  result["misfit"] = 2.1;
  EXPECT_THAT(SummaryOf(result, Known()), HasSubstr("Residuals are 2.1 times what noise"));
}

TEST(Summary, AsksForSmallerDeviationsWhereResidualsAreFarBelow) {
  Json result = Good();
  result["misfit"] = 0.1;
  EXPECT_THAT(SummaryOf(result, Known()), HasSubstr("state smaller ones, such as <code>model_error</code>"));
  result["misfit"] = 0.5;
  EXPECT_THAT(SummaryOf(result, Known()), Not(HasSubstr("state smaller ones")));
}

TEST(Summary, ListsWarnings) {
  Json result = Good();
  EXPECT_THAT(SummaryOf(result, Known()), Not(HasSubstr("warnings")));
  result["warnings"] = {"study.yaml:12: 'a_cg' is off by < 1 m", "static.csv: too heavy"};
  EXPECT_THAT(SummaryOf(result, Known()), AllOf(HasSubstr("<summary>2 warnings about inputs and residuals"),
                                                HasSubstr("is off by &lt; 1 m</li>"), HasSubstr("too heavy</li>")));
}

TEST(Summary, TellsHistoriesByTheirNmse) {
  Json result = Good();
  result["channels"] = Json::parse(R"([{"recording": "sweep", "name": "a", "nmse_percent": 2, "vaf_percent": 98},
                                       {"recording": "sweep", "name": "s", "nmse_percent": 60, "vaf_percent": 40}])");
  EXPECT_THAT(SummaryOf(result, Known()),
              AllOf(HasSubstr("<code>a</code> is within 5 % NMSE"), HasSubstr("Poor: <code>s</code> (60 % NMSE)")));
}

// Next to a node noise is many decibels; far from one a tenth of a decibel may be far beyond noise.
TEST(Summary, JudgesChannelsByNoiseAndModelErrorWhereTheRunHoldsThem) {
  Json result = Good();
  result["channels"] = Json::parse(R"([{"name": "a_cg", "rms_dB": 5.3, "rms_deg": 27, "misfit": 0.7},
                                       {"name": "F_post", "rms_dB": 1.5, "rms_deg": 5, "misfit": 11},
                                       {"name": "a_hub", "rms_dB": 0.4, "rms_deg": 2, "misfit": 4}])");
  EXPECT_THAT(SummaryOf(result, Known()),
              AllOf(HasSubstr("<code>a_cg</code> is within 1.5 times noise and stated model error."),
                    HasSubstr("Poor: <code>F_post</code> (11 times noise and stated model error; 1.5 dB, 5.0\u00b0). "),
                    HasSubstr("Fair: <code>a_hub</code> (4.0 times")));
}

TEST(Summary, TellsRecordingsApartAndWhatItPredicts) {
  Json result = Good();
  result["channels"] = Json::parse(R"([{"recording": "1 Hz", "name": "force", "nmse_percent": 2},
                                       {"recording": "5 Hz", "name": "force", "nmse_percent": 3}])");
  result["validation"] = Json::parse(R"([{"recording": "sweep", "name": "force", "nmse_percent": 8},
                                         {"recording": "10 Hz", "name": "force", "nmse_percent": 1}])");
  EXPECT_THAT(SummaryOf(result, Known()),
              AllOf(HasSubstr("<code>5 Hz</code> and <code>1 Hz</code> are within 5 % NMSE"),
                    HasSubstr("1 of 2 recordings that were not fitted are within 5 % NMSE; the worst is "
                              "<code>sweep</code> (8.0 % NMSE)")));
}

TEST(Summary, CountsChannelsOfOneRecordingAsChannels) {
  Json result = Good();
  result["validation"] = Json::parse(R"([{"recording": "sweep", "name": "a", "nmse_percent": 8},
                                         {"recording": "sweep", "name": "s", "nmse_percent": 1}])");
  EXPECT_THAT(SummaryOf(result, Known()),
              HasSubstr("1 of 2 channels of <code>sweep</code> that were not fitted are within 5 % NMSE"));
  result["validation"][1]["recording"] = "road";
  EXPECT_THAT(SummaryOf(result, Known()), HasSubstr("1 of 2 channels of 2 recordings that were not fitted"));
}

Json Poor(const std::string& name, double deg) {
  return {{"recording", "bounce"}, {"name", name}, {"rms_dB", 3}, {"rms_deg", deg}};
}

TEST(Summary, NamesLeftAndRightTogetherAndCountsTheRest) {
  Json result = Good();
  result["channels"] = {Poor("a_body_FL", 50), Poor("a_body_FR", 51), Poor("a_axle_left", 46),
                        Poor("a_axle_right", 45)};
  EXPECT_THAT(SummaryOf(result, Known()),
              HasSubstr("Poor: <code>a_body_FL</code> and <code>FR</code> (3.0 dB, 51\u00b0) and "
                        "<code>a_axle_left</code> and <code>right</code> (3.0 dB, 46\u00b0). "));
  for (int i = 0; i < 6; ++i) result["channels"].push_back(Poor("z" + std::to_string(i), 31 + i));
  EXPECT_THAT(SummaryOf(result, Known()),
              AllOf(HasSubstr("<code>z2</code> (3.0 dB, 33\u00b0) and 2 more. "), Not(HasSubstr("<code>z1</code>"))));
}

// A model that follows what it was fitted to and misses the rest lacks something.
TEST(Summary, DoesNotCallAModelCompleteThatMissesMoreThanNoise) {
  Json result = Good();
  result["channels"] = Json::parse(R"([{"recording": "sweep", "name": "force", "nmse_percent": 1.3}])");
  EXPECT_THAT(SummaryOf(result, Known()),
              AllOf(HasSubstr("All fitted channels are within tolerance. "), HasSubstr("Nothing is missing")));
  result["misfit"] = 2.2;
  EXPECT_THAT(SummaryOf(result, Known()), AllOf(HasSubstr("Residuals are 2.2 times what noise"),
                                                HasSubstr("fit a richer one"), Not(HasSubstr("Nothing is missing"))));
  // Noise that is larger than stated lacks nothing.
  result["intervals"] = {{"model_error", false}};
  EXPECT_THAT(SummaryOf(result, Known()), AllOf(HasSubstr("State the noise"), Not(HasSubstr("lacks"))));
  result["intervals"]["model_error"] = true;
  EXPECT_THAT(SummaryOf(result, Known()), AllOf(HasSubstr("fit a richer one"), Not(HasSubstr("State the noise"))));
}

// What the fit found first is a delay: no mechanism is asked for before it is corrected.
TEST(Summary, AsksToCorrectAChannelBeforeAMechanism) {
  Json result = Good();
  result["misfit"] = 2.2;
  result["audit"] = Json::parse(R"({"misfit": 0.9, "suspicions": [], "resolutions": [{"seen_from": 0.02}]})");
  result["channels"][1].update(Json::parse(R"({"misfit": 4, "worst": {"lower_Hz": 16, "upper_Hz": 28}})"));
  result["missing"] = Json::parse(R"({"tried": 9, "suggestions": [
      {"mechanism": "delay", "text": "delay of 's_strut'", "expected": "6.94 ms", "fall_percent": 29}]})");
  const auto asks =
      AllOf(HasSubstr("Check the wiring: delay of &#39;s_strut&#39; (6.94 ms)"), Not(HasSubstr("suspects no channel")));
  EXPECT_THAT(SummaryOf(result, Known()), asks);
  result["missing"]["suggestions"][0]["mechanism"] = "friction";
  EXPECT_THAT(SummaryOf(result, Known()), Not(asks));
}

// Neither explained nor missed.
TEST(Summary, TellsAMisfitThatIsLittleMore) {
  Json result = Good();
  result["channels"].erase(1);
  result["misfit"] = 1.4;
  EXPECT_THAT(SummaryOf(result, Known()),
              AllOf(HasSubstr("verdict good"), HasSubstr("Residuals are 1.4 times what noise"),
                    HasSubstr("Little is missing"), Not(HasSubstr("Nothing is missing"))));
}

TEST(Summary, ClaimsNothingThatItHasNotRead) {
  Json result = Good();
  result["versions"]["fourpost"] = "9.9.9";
  result["termination"] = "settled";
  result.erase("misfit");
  result.erase("identifiability");
  EXPECT_THAT(SummaryOf(result, {}),
              AllOf(HasSubstr("of an unknown kind"), HasSubstr("made by fourpost 9.9.9, this page by"),
                    HasSubstr("The run holds no misfit"), Not(HasSubstr("did not converge")),
                    Not(HasSubstr("every parameter")), Not(HasSubstr("Nothing is missing"))));
  result["versions"]["fourpost"] = Versions().front().second;
  EXPECT_THAT(SummaryOf(result, {}), Not(HasSubstr("this page by")));
}

TEST(Summary, KnowsThatTheCompromiseCostHasNoMisfit) {
  Json result = Good();
  result.erase("identifiability");
  result["history_cost"] = "compromise";
  EXPECT_THAT(SummaryOf(result, Known()),
              AllOf(HasSubstr("The compromise cost does not weigh residuals"), Not(HasSubstr("Fit again"))));
}

TEST(Summary, TellsWhatIsNotForetold) {
  Json result = Good();
  result["channels"] = Json::parse(R"([{"recording": "sweep", "name": "force", "nmse_percent": 1.3}])");
  result["validation"] = Json::parse(R"([{"recording": "sine", "name": "force", "nmse_percent": 28},
                                         {"recording": "step", "name": "force", "nmse_percent": 4}])");
  EXPECT_THAT(SummaryOf(result, Known()),
              AllOf(HasSubstr("verdict fair"), HasSubstr("not fitted: <code>sine</code> (28 % NMSE)"),
                    HasSubstr("does not predict the validation recordings"), Not(HasSubstr("Nothing is missing"))));
}

TEST(Summary, SpeaksOfOneParameterInTheSingular) {
  EXPECT_THAT(SummaryOf(Good(), {Known()[0]}), HasSubstr("The one parameter is determined, within 2 %"));
}

// 7.4 N within 0 and 150 N is known to a sixth, whatever the range.
TEST(Summary, CountsADeviationAsAShareOfTheValueWhereTheLowerBoundIsZero) {
  std::vector<ReportedParameter> parameters = Known();
  parameters[1] = {.name = "F", .value = 7.4, .lower = 0, .upper = 150, .sd = 1.2};
  EXPECT_THAT(SummaryOf(Good(), parameters), HasSubstr("Weakly determined: <code>F</code> (16 %)"));
  parameters[1] = {.name = "offset", .value = 0.001, .lower = -0.1, .upper = 0.1, .sd = 0.002};
  EXPECT_THAT(SummaryOf(Good(), parameters), Not(HasSubstr("Weakly")));
}

TEST(Summary, DoesNotCallDeterminedWhatABoundHolds) {
  std::vector<ReportedParameter> parameters = Known();
  parameters[1].at_bound = true;
  EXPECT_THAT(SummaryOf(Good(), parameters), AllOf(HasSubstr("1 of 2 parameters are determined"),
                                                   HasSubstr("Held by a bound, not by the data: <code>k</code>. ")));
}

TEST(Summary, IsPoorWhereTheModelDoesNotExplainItsData) {
  Json result = Good();
  result["verdict"] = {{"explains_data", false}, {"reasons", {"channel 'a' has an NMSE of 240 %"}}};
  EXPECT_THAT(SummaryOf(result, Known()),
              AllOf(HasSubstr("class=\"verdict poor\""),
                    HasSubstr("<strong>The model does not explain the data:</strong> channel &#39;a&#39; has an NMSE"),
                    Not(HasSubstr("The fit converged"))));
  result["verdict"] = {{"explains_data", true}, {"reasons", Json::array()}};
  EXPECT_THAT(SummaryOf(result, Known()), AllOf(HasSubstr("class=\"verdict fair\""), HasSubstr("The fit converged")));
}

TEST(Summary, SaysWhichDerivativesAreNoise) {
  std::vector<ReportedParameter> parameters = Known();
  parameters[1].state = ParameterState::kNoise;
  parameters[1].sd = NAN;
  EXPECT_THAT(SummaryOf(Good(), parameters),
              AllOf(HasSubstr("The derivative is noise: <code>k</code>; residuals jump between neighbouring values"),
                    HasSubstr("1 of 2 parameters are determined"), Not(HasSubstr("Not determined by the data"))));
}

TEST(Summary, SaysWhatWasLeftOutOfTheValidation) {
  Json result = Good();
  result["validation_left_out"] = {{{"recording", "fast"}, {"reason", "is clipped"}}};
  EXPECT_THAT(SummaryOf(result, Known()), HasSubstr("Left out of validation: <code>fast</code> (is clipped)."));
}

TEST(Summary, TellsWhatIsOpenAndWhatToMeasure) {
  Json result = Good();
  result["identifiability"]["rank"] = 1;
  result["static_loads"] = Json::array();
  std::vector<ReportedParameter> parameters = Known();
  parameters[0].sd = HUGE_VAL;
  parameters[1].at_bound = true;
  const std::string acceleration =
      "recording,channel,unit,frequency_Hz,in_band,gain_measured,gain_modelled\nbounce,a_body,m/s^2,1,1,2,2.1\n";
  EXPECT_THAT(SummaryOf(result, parameters, {{"response.csv", acceleration}}),
              AllOf(HasSubstr("Not determined by the data: <code>m</code>"),
                    HasSubstr("not by the data: <code>k</code>"), HasSubstr("Measure a force"),
                    HasSubstr("Check the bounds of <code>k</code>"), HasSubstr("Record the mean offset")));
}

TEST(Summary, TellsTiesOnce) {
  std::vector<ReportedParameter> parameters = Known();
  parameters[0].correlation = parameters[1].correlation = -0.987;
  EXPECT_THAT(SummaryOf(Good(), parameters),
              HasSubstr("<code>m</code> and <code>k</code> are strongly correlated with others (\u22120.99)"));
  parameters[0].correlation = parameters[1].correlation = 0.9;
  EXPECT_THAT(SummaryOf(Good(), parameters), Not(HasSubstr("correlated")));
}

TEST(Summary, SaysThatARunHasNotEnded) {
  Json result = Good();
  result["termination"] = "interrupted";
  result["identifiability"] = nullptr;
  std::vector<ReportedParameter> parameters = Known();
  for (ReportedParameter& parameter : parameters) parameter.sd = NAN;
  EXPECT_THAT(SummaryOf(result, parameters),
              AllOf(HasSubstr("verdict open"), HasSubstr(">Not finished<"), HasSubstr("interrupted"),
                    HasSubstr("<dt>What to do next</dt>"), HasSubstr("before standard deviations"),
                    HasSubstr("Run the same command again")));
}

// The fit of its last step converged.
TEST(Summary, SaysThatAGrowthHasNotEnded) {
  Json result = Good();
  result["misfit"] = 0.9;
  result["channels"].erase(1);
  result["growth"] = {{"added", {"a mount", "friction <b>"}},
                      {"end", "interrupted"},
                      {"interrupted", true},
                      {"not_done", "the last fit"}};
  EXPECT_THAT(SummaryOf(result, Known()),
              AllOf(HasSubstr("verdict open"), HasSubstr("Growth was interrupted after step 2 (friction &lt;b&gt;)."),
                    HasSubstr("Not done: the last fit."), HasSubstr("Run the same command again; growth goes on")));
  result["growth"]["interrupted"] = false;
  EXPECT_THAT(SummaryOf(result, Known()), AllOf(HasSubstr("verdict good"), Not(HasSubstr("interrupted"))));
}

TEST(Summary, ShowsHowAFitGrew) {
  Json result = Good();
  result["growth"] = Json::parse(R"({"end": "nothing more pays", "steps": [
    {"step": 0, "change": "added", "what": "", "misfit": 4.25, "kept": true, "taken_back_by": null},
    {"step": 1, "change": "added", "what": "a <mount>", "misfit": 2, "kept": true, "taken_back_by": 2},
    {"step": 2, "change": "taken back", "what": "a <mount>", "misfit": 2.1, "kept": true, "taken_back_by": null},
    {"step": 3, "change": "added", "what": "gas", "misfit": 1.9, "kept": false, "reason": "too dear"}]})");
  EXPECT_THAT(SummaryOf(result, Known()), AllOf(HasSubstr("4.25"), HasSubstr("with a &lt;mount&gt;"),
                                                HasSubstr("taken back in step 2"), HasSubstr("without a &lt;mount&gt;"),
                                                HasSubstr("no: too dear"), HasSubstr("It ended: nothing more pays.")));
  EXPECT_THAT(SummaryOf(Good(), Known()), Not(HasSubstr("How it grew")));
}

// A refinement that was stopped agrees with nothing.
TEST(Summary, TellsOfAnInterruptedRunWhatItHadDone) {
  Json result = Good();
  result["termination"] = "interrupted";
  result["evaluations"] = {{"paid", 523}};
  result["starts"] = {{"refined", 0}, {"agreeing", 0}};
  EXPECT_THAT(SummaryOf(result, Known()),
              AllOf(HasSubstr("It was stopped after 523 evaluations, before any refinement had ended. "),
                    Not(HasSubstr("same optimum"))));
  result["starts"] = {{"refined", 1}, {"agreeing", 1}};
  EXPECT_THAT(SummaryOf(result, Known()),
              AllOf(HasSubstr("It was stopped after 523 evaluations. Only one refinement ended, "),
                    Not(HasSubstr("same optimum"))));
  result["starts"] = {{"refined", 3}, {"agreeing", 2}};
  EXPECT_THAT(SummaryOf(result, Known()), HasSubstr("2 of 3 refinements that had ended, each from its own start"));
}

// The tile, the verdict, the list and the advice.
TEST(Summary, NamesOneWorstChannelEverywhere) {
  Json result = Good();
  result["misfit"] = 2.2;
  result["channels"] = Json::parse(R"([
    {"name": "a_cg", "rms_dB": 5.3, "rms_deg": 27, "misfit": 0.7,
     "worst": {"recording": "bounce", "band_Hz": [8, 12], "misfit": 30}},
    {"name": "s_strut", "rms_dB": 3.1, "rms_deg": 9, "misfit": 5.9,
     "worst": {"recording": "pitch", "band_Hz": [0.5, 1], "misfit": 11.2}}])");
  EXPECT_THAT(SummaryOf(result, Known()),
              AllOf(HasSubstr("data-worst=\"s_strut\""), HasSubstr("largest in pitch at 0.5\u20131 Hz"),
                    HasSubstr("Worst channel: <code>s_strut</code>, 5.9 times noise and stated model error; largest in "
                              "<code>pitch</code> from 0.5 to 1 Hz (11 times there)."),
                    HasSubstr("Poor: <code>s_strut</code> (5.9 times noise and stated model error; 3.1 dB"),
                    HasSubstr("Check the wiring of <code>s_strut</code>"), HasSubstr("near 0.71 Hz"),
                    Not(HasSubstr("bounce"))));
}

TEST(Summary, EscapesNames) {
  Json result = Good();
  result["channels"][0]["name"] = "<b>";
  EXPECT_THAT(SummaryOf(result, Known()), AllOf(HasSubstr("<code>&lt;b&gt;</code>"), Not(HasSubstr("<code><b>"))));
}

}  // namespace
}  // namespace fourpost::report_summary_test
