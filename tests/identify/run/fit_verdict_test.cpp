#include "identify/run/fit_verdict.h"

#include <gmock/gmock.h>

#include "identify/run/findings.h"
#include "identify/uncertainty/findings.h"
#include "tests/findings.h"

namespace fourpost::fit_verdict_test {
namespace {

ErrorShare Share(const std::string& channel, const std::string& recording, double measured, double nmse_percent) {
  return {.channel = channel,
          .recording = recording,
          .kind = "m",
          .unit = "m",
          .has_nodes = true,
          .error = nmse_percent / 100 * measured,
          .measured = measured};
}

TEST(FitVerdict, NothingSpeaksAgainstAFitThatFollowsItsChannels) {
  std::vector<ErrorShare> misfits;
  misfits = {Share("s_front", "bounce", 4, 5), Share("s_rear", "bounce", 1, 60)};
  EXPECT_TRUE(JudgeFit({}, misfits).explains());
  EXPECT_THAT(ConclusionsOf({}, JudgeFit({}, misfits), true), testing::Not(Reports(kModelUnexplaining, 0)));
}

TEST(FitVerdict, NamesAChannelThatIsWorseThanAConstant) {
  std::vector<ErrorShare> misfits;
  misfits = {Share("s_front", "bounce", 4, 1), Share("s_front", "pitch", 4, 1), Share("s_rear", "bounce", 1, 240),
             Share("s_rear", "pitch", 1, 240)};
  const FitVerdict verdict = JudgeFit({}, misfits);
  EXPECT_THAT(verdict.reasons, Reports(kChannelUnexplained, 0, {"'s_rear'", "240 %"}));
  EXPECT_EQ(verdict.reasons.items().size(), 1u) << verdict.reasons.Format();
  EXPECT_THAT(ConclusionsOf({}, verdict, true), Reports(kModelUnexplaining, 0, {"'s_rear'", "240 %"}));
}

TEST(FitVerdict, NamesWhatCouldNotBeTakenIntoAccount) {
  FitResult fit;
  fit.is_input_noise_implausible = fit.are_calibrations_unused = true;
  const Diagnostics conclusions = ConclusionsOf(fit, {}, true);
  EXPECT_THAT(conclusions, Reports(kPostNoiseImplausible, 0));
  EXPECT_THAT(conclusions, Reports(kCalibrationUnused, 0));
}

TEST(FitVerdict, NamesHeldParametersWithoutADerivative) {
  FitResult fit;
  fit.certainty.emplace();
  EXPECT_THAT(ConclusionsOf(fit, {}, true), testing::Not(Reports(kHeldLeftOut, 0)));
  fit.certainty->held_left_out = {"k_stop", "gap"};
  EXPECT_THAT(ConclusionsOf(fit, {}, true), Reports(kHeldLeftOut, 0, {"k_stop, gap"}));
}

TEST(FitVerdict, NamesParametersThatOnlyTheirBoundsLimit) {
  FitResult fit;
  fit.covariance.emplace();
  fit.parameters = {{.name = "m_body", .value = 978, .lower = 923, .upper = 1021},
                    {.name = "k", .value = 20, .lower = 10, .upper = 40}};
  for (FittedParameter& parameter : fit.parameters) parameter.state = ParameterState::kUndetermined;
  fit.parameters[0].lower_95 = 923;
  fit.parameters[0].upper_95 = 1021;
  fit.parameters[1].lower_95 = 15;
  fit.parameters[1].upper_95 = 25;
  const Diagnostics conclusions = ConclusionsOf(fit, {}, true);
  EXPECT_THAT(conclusions, Reports(kIntervalFillsBounds, 0, {"do not determine: m_body"}));
  EXPECT_THAT(conclusions, testing::Not(Reports(kIntervalFillsBounds, 0, {"m_body, k"})));
  EXPECT_THAT(conclusions, testing::Not(Reports(kHeldFillsBounds, 0)));
  // Another channel would not help against a mass that is known to its range alone.
  fit.parameters[0].limited_by = "held: m_wheel";
  const Diagnostics of_held = ConclusionsOf(fit, {}, true);
  EXPECT_THAT(of_held, Reports(kHeldFillsBounds, 0, {"m_body (m_wheel)"}));
  EXPECT_THAT(of_held, testing::Not(Reports(kIntervalFillsBounds, 0)));
}

// Friction that ends at zero is none; a weighed mass may end two deviations from what was weighed.
TEST(FitVerdict, NamesParametersThatEndedWhereNoneWasExpected) {
  FitResult fit;
  fit.parameters = {{.name = "F_gas", .value = 100, .lower = 0, .upper = 100},
                    {.name = "F_seal", .value = 0, .lower = 0, .upper = 50},
                    {.name = "m", .start = 1485, .value = 1300, .prior_sd = 8, .lower = 1300, .upper = 1700},
                    {.name = "m_axle", .start = 100, .value = 103, .prior_sd = 1, .lower = 50, .upper = 200}};
  for (const std::size_t i : {0U, 1U, 2U}) fit.parameters[i].at_bound = true;
  const Diagnostics conclusions = ConclusionsOf(fit, {}, true);
  EXPECT_THAT(conclusions, Reports(kEndedAtBounds, 0, {"F_gas (upper), m (lower)"}));
  EXPECT_THAT(conclusions, Reports(kFarFromPrior, 0, {"m by -23 standard deviations"}));
  EXPECT_THAT(conclusions, testing::Not(Reports(kFarFromPrior, 0, {"m_axle"})));
}

// Two starts may well end apart, and one refinement has nothing to agree with.
TEST(FitVerdict, NamesABestOptimumThatOneOfManyRefinementsFound) {
  FitResult fit;
  fit.end = FitEnd::kConverged;
  const auto of = [&](int agreeing, int starts) {
    fit.agreeing = agreeing;
    fit.starts = starts;
    return ConclusionsOf(fit, {}, true);
  };
  EXPECT_THAT(of(1, 5), Reports(kRefinementsDisagree, 0, {"1 of 5"}));
  EXPECT_THAT(of(1, 3), Reports(kRefinementsDisagree, 0, {"1 of 3"}));
  EXPECT_THAT(of(2, 5), testing::Not(Reports(kRefinementsDisagree, 0)));
  EXPECT_THAT(of(1, 2), testing::Not(Reports(kRefinementsDisagree, 0)));
  fit.end = FitEnd::kInterrupted;
  EXPECT_THAT(of(1, 5), testing::Not(Reports(kRefinementsDisagree, 0)));
}

TEST(FitVerdict, DoesNotJudgeAFitThatWasInterrupted) {
  std::vector<ErrorShare> misfits;
  misfits = {Share("s_rear", "bounce", 1, 240)};
  FitResult fit;
  fit.end = FitEnd::kConverged;
  EXPECT_FALSE(JudgeFit(fit, misfits).explains());
  fit.end = FitEnd::kInterrupted;
  EXPECT_TRUE(JudgeFit(fit, misfits).explains());
}

// Of one recording a channel may be next to a node: over all recordings it is judged.
TEST(FitVerdict, AChannelIsJudgedOverAllRecordings) {
  std::vector<ErrorShare> misfits;
  misfits = {Share("a_cg", "bounce", 4, 1), Share("a_cg", "pitch", 1, 300), Share("a_front", "pitch", 4, 1)};
  EXPECT_EQ(JudgeFit({}, misfits).reasons.Format(), "");
}

TEST(FitVerdict, AQuietChannelIsNotJudged) {
  std::vector<ErrorShare> misfits;
  // A tenth as a root mean square is a hundredth of the squares.
  misfits = {Share("s_front", "bounce", 1, 1), Share("s_middle", "bounce", 0.0099, 1000)};
  EXPECT_TRUE(JudgeFit({}, misfits).explains());
  misfits[1].measured = 0.0101;
  misfits[1].error = 0.0102;
  EXPECT_FALSE(JudgeFit({}, misfits).explains());
  // Nothing else of its kind.
  misfits[1] = Share("s_middle", "bounce", 1e-6, 101);
  misfits[1].kind = "N";
  EXPECT_FALSE(JudgeFit({}, misfits).explains());
}

// On a road axles are ten times as loud as the body, whose accelerometer may be upside down.
TEST(FitVerdict, OverTimeAQuietChannelIsJudged) {
  std::vector<ErrorShare> misfits;
  misfits = {Share("a_axle", "road", 400, 1), Share("a_body", "road", 1, 170)};
  for (ErrorShare& share : misfits) share.has_nodes = false;
  EXPECT_FALSE(JudgeFit({}, misfits).explains());
  // What it takes of motion across its axis.
  misfits[1] = Share("a_body", "road", 0.1, 170);
  misfits[1].has_nodes = false;
  EXPECT_TRUE(JudgeFit({}, misfits).explains());
}

TEST(FitVerdict, NamesARecordingThatIsNotModelledAtAll) {
  std::vector<ErrorShare> misfits;
  misfits = {Share("s_front", "bounce", 4, 1), Share("s_rear", "bounce", 4, 1), Share("s_front", "pitch", 1, 150),
             Share("s_rear", "pitch", 1, 130)};
  const Diagnostics reasons = JudgeFit({}, misfits).reasons;
  EXPECT_THAT(reasons, Reports(kRecordingUnexplained, 0, {"'pitch' in m", "140 %"}));
  EXPECT_EQ(reasons.items().size(), 1u) << reasons.Format();
}

FitResult Bounded(int at_bound, int parameters, double misfit) {
  FitResult fit;
  fit.parameters.resize(static_cast<std::size_t>(parameters));
  for (int i = 0; i < at_bound; ++i) fit.parameters[static_cast<std::size_t>(i)].at_bound = true;
  fit.covariance = Covariance{};
  fit.residual_count = 100;
  fit.data_squares = 100 * misfit * misfit;
  return fit;
}

TEST(FitVerdict, MostParametersAtBoundsExplainNothingWhereResidualsAreLarge) {
  EXPECT_THAT(JudgeFit(Bounded(3, 5, 2), {}).reasons, Reports(kParametersAtBounds, 0, {"3 of 5"}));
  EXPECT_TRUE(JudgeFit(Bounded(2, 5, 2), {}).explains());
  EXPECT_TRUE(JudgeFit(Bounded(2, 4, 2), {}).explains());
  // No friction where there is none to find.
  EXPECT_TRUE(JudgeFit(Bounded(1, 1, 1), {}).explains());
}

/// `poor` of `channels` with an NMSE of this many per cent, the others followed.
std::vector<ErrorShare> Channels(int poor, int channels, double nmse_percent) {
  std::vector<ErrorShare> shares;
  for (int i = 0; i < channels; ++i)
    shares.push_back(Share("a_" + std::to_string(i), "bounce", 1, i < poor ? nmse_percent : 1));
  return shares;
}

TEST(FitVerdict, AQuarterAtBoundsExplainsNothingWhereResidualsAreFarTooLargeAndChannelsAreMissed) {
  EXPECT_THAT(JudgeFit(Bounded(7, 18, 4.3), Channels(10, 16, 12)).reasons,
              Reports(kParametersAtBounds, 0, {"7 of 18", "4.3"}));
  EXPECT_FALSE(JudgeFit(Bounded(3, 11, 3.01), Channels(9, 16, 5.1)).explains());
  // A quarter, a misfit that is not far above, half of the channels, and errors that do not show.
  EXPECT_TRUE(JudgeFit(Bounded(3, 12, 3.01), Channels(9, 16, 5.1)).explains());
  EXPECT_TRUE(JudgeFit(Bounded(3, 11, 2.99), Channels(9, 16, 5.1)).explains());
  EXPECT_TRUE(JudgeFit(Bounded(3, 11, 3.01), Channels(8, 16, 5.1)).explains());
  EXPECT_TRUE(JudgeFit(Bounded(3, 11, 3.01), Channels(9, 16, 4.9)).explains());
  // Recordings without noise.
  EXPECT_TRUE(JudgeFit(Bounded(3, 11, 50), Channels(0, 16, 0)).explains());
}

TEST(FitVerdict, MostChannelsPoorExplainNothingWhereResidualsAreLarge) {
  EXPECT_THAT(JudgeFit(Bounded(0, 5, 1.6), Channels(9, 16, 20.1)).reasons,
              Reports(kMostChannelsPoor, 0, {"9 of 16", "20 %", "1.6"}));
  EXPECT_TRUE(JudgeFit(Bounded(0, 5, 1.6), Channels(8, 16, 20.1)).explains());
  EXPECT_TRUE(JudgeFit(Bounded(0, 5, 1.6), Channels(9, 16, 19.9)).explains());
  // Noise, or a model error that the study states, explains it.
  EXPECT_TRUE(JudgeFit(Bounded(0, 5, 1.4), Channels(16, 16, 60)).explains());
  // Without noise nothing says how large it may be.
  EXPECT_TRUE(JudgeFit({}, Channels(16, 16, 60)).explains());
}

TEST(Conclusions, AreNoneOfAFitThatConvergedAndDeterminesAll) {
  FitResult fit = Bounded(0, 3, 1);
  fit.end = FitEnd::kConverged;
  EXPECT_EQ(ConclusionsOf(fit, {}, true).Format(), "");
  EXPECT_THAT(ConclusionsOf(fit, {}, false), Reports(kCompromiseWithoutDeviations, 0));
  fit.end = FitEnd::kNotConverged;
  fit.message = "50 iterations";
  EXPECT_THAT(ConclusionsOf(fit, {}, true), Reports(kFitNotConverged, 0, {"50 iterations"}));
  fit.covariance.reset();
  EXPECT_THAT(ConclusionsOf(fit, {}, true), Reports(kEndedWithoutDeviations, 0));
}

TEST(Conclusions, NameWhatHasNoStandardDeviation) {
  FitResult fit = Bounded(0, 2, 1);
  fit.parameters[1].name = "v_knee";
  fit.parameters[1].state = ParameterState::kNoise;
  fit.covariance->directions = Eigen::MatrixXd::Identity(2, 2);
  fit.covariance->rank = 1;
  fit.weakest = {"m +1 %, k +1 %"};
  const Diagnostics conclusions = ConclusionsOf(fit, {}, true);
  EXPECT_THAT(conclusions, Reports(kDerivativeNoise, 0, {"v_knee"}));
  EXPECT_THAT(conclusions, Reports(kDirectionUndetermined, 0, {"m +1 %, k +1 %"}));
  fit.weakest = {"v_knee +1 %"};
  EXPECT_THAT(ConclusionsOf(fit, {}, true), Reports(kWithoutEffect, 0, {"change with v_knee"}));
  fit.covariance->directions = Eigen::MatrixXd::Identity(1, 1);
  fit.covariance->rank = 0;
  EXPECT_THAT(ConclusionsOf(fit, {}, true), Reports(kParameterUndetermined, 0));
}

// 110 beside 100 is within noise; the other end has been there before.
TEST(FitVerdict, NamesOtherOptimaThatTheDataAllow) {
  FitResult fit;
  fit.cost = 100;
  fit.parameters = {{.name = "k", .value = 10, .lower = 1, .upper = 100}};
  fit.covariance.emplace();
  fit.covariance->directions = fit.covariance->singular_values = Eigen::MatrixXd::Ones(1, 1);
  fit.covariance->rank = 1;
  fit.certainty.emplace();
  fit.certainty->judged = {0};
  fit.certainty->noise_covariance = fit.certainty->total_covariance = 1e-4 * Eigen::MatrixXd::Identity(1, 1);
  fit.refined = {{.from = "search", .end = RefineEnd::kConverged, .cost = 100, .agrees = true, .values = {10}},
                 {.from = "search", .end = RefineEnd::kConverged, .cost = 110, .values = {40}},
                 {.from = "search", .end = RefineEnd::kIterations, .cost = 111, .values = {60}},
                 {.from = "vehicle file", .end = RefineEnd::kConverged, .cost = 900, .values = {80}}};
  EXPECT_THAT(ConclusionsOf(fit, {}, true), Reports(kOtherOptima, 0, {"another optimum", "110", "100"}));
  fit.refined[1].values = {10.05};
  EXPECT_THAT(ConclusionsOf(fit, {}, true), testing::Not(Reports(kOtherOptima, 0)));
}

}  // namespace
}  // namespace fourpost::fit_verdict_test
