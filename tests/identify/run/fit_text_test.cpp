#include "identify/run/fit_text.h"

#include <gmock/gmock.h>

namespace fourpost::fit_text_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string TextOf(const FitResult& fit, const FitOverview& overview = {}) {
  return FitText(fit, overview, {}, {}, "", nullptr);
}

TEST(FitText, SaysHowMuchOfADeviationIsThatOfHeldOnes) {
  FitResult fit;
  fit.parameters = {{.name = "k", .value = 2, .lower = 1, .upper = 3, .limited_by = "held: kt", .unit = "1"}};
  FittedParameter& k = fit.parameters[0];
  k.sd = 0.4;
  k.noise_sd = 0.1;
  EXPECT_THAT(TextOf(fit), HasSubstr("sd 4.0 times smaller if that were known"));
  k.model_sd = 0.38;
  EXPECT_THAT(TextOf(fit), Not(HasSubstr("if that were known")));
}

TEST(FitText, MarksEndsThatAreCutAtABound) {
  FitResult fit;
  fit.parameters = {{.name = "k", .value = 2, .lower = 1, .upper = 3, .sd = 0.4, .unit = "1"}};
  FittedParameter& k = fit.parameters[0];
  k.lower_95 = 1.2;
  k.upper_95 = 2.8;
  EXPECT_THAT(TextOf(fit), Not(HasSubstr("cut")));
  k.upper_95 = k.upper;
  EXPECT_THAT(TextOf(fit), HasSubstr("interval cut at upper bound"));
  k.lower_95 = k.lower;
  k.sd = 4;
  k.state = ParameterState::kUndetermined;
  EXPECT_THAT(TextOf(fit), HasSubstr("not determined, interval cut at both bounds"));
}

TEST(FitText, SpeaksInTheWordsOfTheOverview) {
  FitResult fit;
  fit.covariance.emplace();
  const FitOverview overview{.verdict = "fair",
                             .misfit = 2.17,
                             .explained = Explained::kNo,
                             .channels = {{.name = "s", .misfit = 5.88, .worst = WorstPlace{"pitch", 0.5, 1, 11.2}}},
                             .disagree = {"octaves"},
                             .disagreement = {62.3},
                             .wider_than_by_noise = 4.8};
  EXPECT_THAT(TextOf(fit, overview),
              AllOf(HasSubstr("Fit: fair. Residuals are 2.2 times what noise and the stated model error explain"),
                    HasSubstr("Worst channel: 's', 5.9 times noise and stated model error; largest in 'pitch' from "
                              "0.5 to 1 Hz (11 times there).\n"),
                    HasSubstr("Parts of the data (octaves) ask for different parameters, beyond noise;"),
                    HasSubstr("between octaves 62 times as much"), HasSubstr("would be 4.8 times narrower")));
}

TEST(FitText, WrapsWhatStandsBeforeASentenceWithIt) {
  constexpr std::size_t kWidth = 118;
  FitResult fit;
  fit.covariance.emplace();
  const std::string text = TextOf(fit, {.verdict = "open",
                                        .misfit = 2.17,
                                        .explained = Explained::kNo,
                                        .is_calibrated = true,
                                        .is_mostly_post_noise = true});
  const std::size_t begin = text.find("Fit: not finished. Residuals are 2.2 times");
  ASSERT_NE(begin, std::string::npos);
  EXPECT_LE(text.find('\n', begin) - begin, kWidth);
}

TEST(FitText, LeavesTheModelAloneWhereTheStatedErrorExplainsThatPartsDisagree) {
  FitOverview overview{.misfit = 0.5, .explained = Explained::kYes, .disagree = {"octaves"}, .disagreement = {3}};
  EXPECT_THAT(TextOf({}, overview),
              AllOf(HasSubstr("by no more than the stated model error"), Not(HasSubstr("lacks"))));
  overview.explained = Explained::kNearly;
  EXPECT_THAT(TextOf({}, overview), HasSubstr("model lacks something"));
}

}  // namespace
}  // namespace fourpost::fit_text_test
