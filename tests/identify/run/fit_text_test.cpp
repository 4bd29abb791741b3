#include "identify/run/fit_text.h"

#include <gmock/gmock.h>

namespace fourpost::fit_text_test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string TextOf(const FitResult& fit) { return FitText(fit, {}, {}, "", nullptr); }

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

TEST(FitText, AsksForSmallerDeviationsWhereResidualsAreFarBelow) {
  FitResult fit;
  fit.covariance.emplace();
  fit.covariance->rank = 1;
  fit.residual_count = 101;
  fit.data_squares = 100 * 0.25 * 0.25;
  EXPECT_THAT(TextOf(fit), HasSubstr("state smaller ones, such as 'model_error'"));
  fit.data_squares = 100 * 0.35 * 0.35;
  EXPECT_THAT(TextOf(fit), Not(HasSubstr("state smaller ones")));
}

TEST(FitText, LeavesTheModelAloneWhereTheStatedErrorExplainsThatPartsDisagree) {
  FitResult fit;
  fit.covariance.emplace();
  fit.covariance->rank = 1;
  fit.certainty.emplace();
  fit.certainty->model_error.is_significant = true;
  fit.certainty->judged = {0};
  fit.certainty->noise_sd = fit.certainty->total_sd = Eigen::VectorXd::Ones(1);
  fit.residual_count = 101;
  fit.data_squares = 100 * 0.25 * 0.25;
  EXPECT_THAT(TextOf(fit), AllOf(HasSubstr("by no more than the stated model error"), Not(HasSubstr("lacks"))));
  fit.data_squares = 100 * 1.5 * 1.5;
  EXPECT_THAT(TextOf(fit), HasSubstr("the model lacks something"));
}

}  // namespace
}  // namespace fourpost::fit_text_test
