#include "identify/report/fit_overview.h"

#include <cmath>

#include <gmock/gmock.h>

namespace fourpost::fit_overview_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

Json Fit() {
  return Json::parse(R"({
    "termination": "converged", "misfit": 0.9, "expected_squares": 95.5, "starts": {"refined": 5, "agreeing": 5},
    "channels": [{"name": "a", "rms_dB": 0.2, "rms_deg": 1, "misfit": 0.8},
                 {"name": "s", "rms_dB": 0.3, "rms_deg": 2, "misfit": 1.2,
                  "worst": {"recording": "pitch", "band_Hz": [0.5, 1], "misfit": 1.44}}]})");
}

Json Disagreeing() {
  Json result = Fit();
  result["intervals"] = Json::parse(R"({"model_error": true, "wider_than_by_noise": 4.8, "ways": [
      {"by": "sensor groups", "is_beyond_noise": false, "disagreement": 1.1},
      {"by": "octaves", "is_beyond_noise": true, "disagreement": 9}]})");
  return result;
}

TEST(FitOverview, IsOneTableOfFigures) {
  const FitOverview overview = OverviewOf(Fit());
  EXPECT_EQ(overview.verdict, "good");
  EXPECT_EQ(overview.explained, Explained::kYes);
  ASSERT_NE(overview.Worst(), nullptr);
  EXPECT_EQ(overview.Worst()->name, "s");
  EXPECT_EQ(OverviewJson(overview), nlohmann::ordered_json::parse(R"({
    "verdict": "good", "misfit": 0.9, "expected_squares": 95.5, "is_calibrated": false,
    "worst": {"name": "s", "misfit": 1.2, "place": {"recording": "pitch", "band_Hz": [0.5, 1.0], "misfit": 1.44}}})"));
}

TEST(FitOverview, TakesDegreesOfFreedomForWhatSquaresOfAnOlderRunAreExpectedToBe) {
  Json result = Fit();
  result.erase("expected_squares");
  EXPECT_TRUE(std::isnan(OverviewOf(result).expected_squares));
  result.update({{"residuals", 100}, {"identifiability", {{"rank", 4}}}});
  EXPECT_EQ(OverviewOf(result).expected_squares, 96);
}

TEST(FitOverview, CallsAFitThatWasInterruptedNotFinished) {
  EXPECT_EQ(VerdictWord({.verdict = "open"}), "not finished");
  EXPECT_EQ(VerdictWord({.verdict = "fair"}), "fair");
}

TEST(FitOverview, NamesTheWorstChannelAndWhereItIsWorst) {
  EXPECT_EQ(WorstSentence(OverviewOf(Fit())),
            "Worst channel: `s`, 1.2 times noise and stated model error; largest in `pitch` from 0.5 to 1 Hz (1.4 "
            "times there).");
  EXPECT_EQ(WorstSentence(OverviewOf(Json::object())), "");
}

// By the verdict on channels first: what looks alike is not worse than what does not.
TEST(FitOverview, TakesForTheWorstChannelOneThatIsPoor) {
  Json result = Fit();
  result["channels"][0].update({{"misfit", 9}});
  result["channels"][1].update({{"misfit", 4}, {"rms_dB", 3}});
  EXPECT_EQ(OverviewOf(result).Worst()->name, "s");
}

TEST(FitOverview, CallsNoFitGoodThatHasAPoorChannelOrContradictsItself) {
  Json poor = Fit();
  poor["channels"][1].update({{"misfit", 4}, {"rms_dB", 3}});
  EXPECT_EQ(OverviewOf(poor).verdict, "fair");
  Json unseen = Fit();
  unseen["validation"] = {poor["channels"][1]};
  EXPECT_EQ(OverviewOf(unseen).verdict, "fair");
  Json large = Fit();
  large["misfit"] = 1.6;
  EXPECT_EQ(OverviewOf(large).verdict, "fair");
  Json apart = Disagreeing();
  apart["misfit"] = 1.2;
  EXPECT_EQ(OverviewOf(apart).verdict, "fair");
  Json alone = Fit();
  alone["starts"]["agreeing"] = 1;
  EXPECT_EQ(OverviewOf(alone).verdict, "fair");
}

TEST(FitOverview, IsPoorOrOpenByHowItEnded) {
  Json result = Fit();
  result["verdict"] = {{"reasons", {"worse than no model"}}};
  EXPECT_EQ(OverviewOf(result).verdict, "poor");
  result["termination"] = "interrupted";
  EXPECT_EQ(OverviewOf(result).verdict, "open");
  result["termination"] = "not_converged";
  EXPECT_EQ(OverviewOf(result).verdict, "poor");
}

// Explained as a whole, and yet parts disagree: said so that both are true.
TEST(FitOverview, ReconcilesWhatIsExplainedWithWhatDisagrees) {
  Json result = Disagreeing();
  const FitOverview overview = OverviewOf(result);
  EXPECT_THAT(overview.disagree, ElementsAre("octaves"));
  EXPECT_EQ(overview.verdict, "good");
  EXPECT_THAT(ResidualSentence(overview), HasSubstr("0.90 times what noise and the stated model error explain: as a "
                                                    "whole these explain the residuals."));
  EXPECT_THAT(DisagreementSentence(overview),
              AllOf(HasSubstr("Parts of the data (octaves) still ask for different parameters, by no more than the "
                              "stated model error allows"),
                    Not(HasSubstr("beyond noise"))));
  result["misfit"] = 2.2;
  EXPECT_THAT(DisagreementSentence(OverviewOf(result)), HasSubstr("ask for different parameters, beyond noise"));
}

TEST(FitOverview, OfARunThatSaysNothingSaysNothing) {
  const FitOverview overview = OverviewOf(Json::object());
  EXPECT_EQ(overview.verdict, "poor");
  EXPECT_TRUE(std::isnan(overview.misfit));
  EXPECT_EQ(ResidualSentence(overview) + WorstSentence(overview) + DisagreementSentence(overview), "");
}

}  // namespace
}  // namespace fourpost::fit_overview_test
