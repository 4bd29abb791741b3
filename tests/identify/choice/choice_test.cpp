// The choice on a stand-in whose metrics are known functions of two parameters.
#include "identify/choice/choice.h"

#include <cmath>
#include <functional>
#include <string>

#include <gmock/gmock.h>

#include "analysis/text/diagnostics.h"
#include "identify/choice/choice_answer.h"
#include "identify/choice/engine_error.h"
#include "identify/choice/findings.h"
#include "identify/choice/setting_search.h"
#include "identify/search/draws.h"
#include "tests/findings.h"

namespace fourpost::choice_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

Knob KnobOf(const std::string& name, std::size_t parameter, int positions, std::optional<std::size_t> now) {
  Knob knob{.name = name, .line = static_cast<int>(parameter) + 2, .parameters = {parameter}, .now = now};
  knob.change = now ? Knob::Change::kDifference : Knob::Change::kAbsolute;
  for (int i = 0; i < positions; ++i) knob.positions.push_back({std::to_string(i), {0.1 * i}});
  return knob;
}

/// Two parameters x and y about 1, of which a car has its own; a good one is at x = 1.3 + s, y = 1.2 with a third,
/// doubtful s. Metrics on one road: discomfort, slip, and travel x.
MatrixXd StandInMetrics(std::span<const double> p) {
  MatrixXd metrics(1, 3);
  metrics(0, 0) = 1 + std::pow(p[0] - 1.3 - p[2], 2) + 0.5 * std::pow(p[1] - 1.2, 2);
  metrics(0, 1) = 1 + std::pow(p[1] - 1.6, 2);
  metrics(0, 2) = p[0];
  return metrics;
}

/// Now at x = 1, y = 1: position 5 of 11.
ChoiceRequest StandIn(double doubt = 0.05, std::size_t draws = 60) {
  ChoiceRequest request;
  request.settings.file = "settings.yaml";
  request.settings.knobs = {KnobOf("x", 0, 11, 5), KnobOf("y", 1, 11, 5)};
  request.settings.roads = {{.name = "B", .road_class = "B", .speed = 20}};
  request.settings.objectives = {{.metric = 0, .weight = 1}};
  request.metrics = {{.name = "discomfort"}, {.name = "slip"}, {.name = "travel", .dimension = kLength, .unit = "mm"}};
  request.spectra = StandInMetrics;
  request.fitted = {1, 1, 0};
  request.parameters = {"x", "y", "s"};
  request.threads = 1;
  if (draws == 0) return request;
  request.draws = MatrixXd(static_cast<Index>(draws), 3);
  for (Index d = 0; d < request.draws.rows(); ++d)
    request.draws.row(d) << 1, 1, doubt * Draws(1, DrawPurpose::kNoise, 0, static_cast<std::size_t>(d)).Normal();
  return request;
}

std::string BestOf(const ChoiceRequest& request, const Choice& choice) {
  return choice.best ? SettingText(request.settings.knobs, choice.rows[*choice.best].setting) : "none";
}

/// Every number of a choice by plain loops over cars and settings.
TEST(Choice, IsWhatBruteForceFinds) {
  const ChoiceRequest request = StandIn();
  const Choice choice = Choose(request, {});
  ASSERT_EQ(choice.rows.size(), 121U);
  std::vector<double> wins(121, 0);
  std::vector<double> means(121, 0);
  std::vector<double> regrets(121, 0);
  std::vector<std::vector<double>> costs(121);
  const auto draws = static_cast<double>(request.draws.rows());
  for (Index d = 0; d < request.draws.rows(); ++d) {
    std::vector<double> of_car;
    for (int i = 0; i < 11; ++i)
      for (int j = 0; j < 11; ++j) {
        const std::vector<double> car = {1 + 0.1 * (i - 5), 1 + 0.1 * (j - 5), request.draws(d, 2)};
        of_car.push_back(StandInMetrics(car)(0, 0) / StandInMetrics(std::vector<double>{1, 1, car[2]})(0, 0));
      }
    const double least = *std::min_element(of_car.begin(), of_car.end());
    for (std::size_t s = 0; s < of_car.size(); ++s) {
      wins[s] += of_car[s] == least ? 1 / draws : 0;
      means[s] += of_car[s] / draws;
      regrets[s] += (of_car[s] - least) / draws;
      costs[s].push_back(of_car[s]);
    }
  }
  const auto best = static_cast<std::size_t>(std::min_element(means.begin(), means.end()) - means.begin());
  EXPECT_EQ(choice.best, best);
  EXPECT_EQ(BestOf(request, choice), "x 8, y 7");
  EXPECT_EQ(choice.present, 5 * 11 + 5U);
  // Sums in another order.
  constexpr double kRounding = 1e-12;
  for (std::size_t s = 0; s < means.size(); ++s) {
    EXPECT_NEAR(choice.rows[s].change.mean, means[s] - 1, kRounding);
    EXPECT_NEAR(choice.rows[s].regret, regrets[s], kRounding);
    EXPECT_NEAR(choice.rows[s].best_probability, wins[s], kRounding);
  }
  EXPECT_EQ(choice.lattice, 121);
  EXPECT_FALSE(choice.was_searched);
  // The quantile of 2.5 % of 60 paired differences lies between the second and the third.
  for (std::size_t s = 0; s < costs.size(); ++s) {
    std::vector<double> differences;
    for (std::size_t d = 0; d < costs[s].size(); ++d) differences.push_back(costs[s][d] - costs[best][d]);
    std::sort(differences.begin(), differences.end());
    EXPECT_EQ(choice.rows[s].is_indistinct, std::lerp(differences[1], differences[2], 0.475) <= 0) << s;
  }
  // Some are, most are not.
  EXPECT_GT(choice.IndistinctCount(), 1U);
  EXPECT_LT(choice.IndistinctCount(), 30U);
  ASSERT_FALSE(choice.deciding.empty());
  EXPECT_EQ(choice.deciding[0].parameter, 2U);
  EXPECT_GT(choice.deciding[0].explained, 0.99);
  ASSERT_EQ(choice.clicks.size(), 2U);
  // A click of x costs 0.01, of y half of that, over 1 + 0.09 + 0.02 now.
  EXPECT_NEAR(choice.clicks[1].loss, 0.005 / 1.11, 1e-3);
  EXPECT_GT(choice.clicks[0].loss, choice.clicks[1].loss);
}

TEST(Choice, IsTheSameForAnyNumberOfThreads) {
  ChoiceRequest request = StandIn();
  ChoiceAnswer one{.subject = "run", .confidence = "95 %", .request = request, .choice = Choose(request, {})};
  request.threads = 3;
  ChoiceAnswer three = one;
  three.choice = Choose(request, {});
  EXPECT_EQ(ChoiceJson(one), ChoiceJson(three));
  EXPECT_EQ(ChoiceFiles(one).front().second, ChoiceFiles(three).front().second);
}

TEST(Choice, OfOneCarHasNoDoubt) {
  const ChoiceRequest request = StandIn(0, 0);
  const Choice choice = Choose(request, {});
  EXPECT_EQ(BestOf(request, choice), "x 8, y 7");
  EXPECT_EQ(choice.IndistinctCount(), 1U);
  EXPECT_EQ(choice.rows[*choice.best].best_probability, 1);
  EXPECT_TRUE(choice.deciding.empty());
  EXPECT_TRUE(choice.runs.empty());
}

TEST(Choice, WeighsTwoObjectivesAndHasTheirFront) {
  ChoiceRequest request = StandIn(0, 0);
  request.settings.objectives = {{.metric = 0, .weight = 0.5}, {.metric = 1, .weight = 0.5}};
  const Choice choice = Choose(request, {});
  // x at its optimum; y from its own, 7, to the other one's, 10, which is the last position.
  ASSERT_EQ(choice.front.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(choice.rows[choice.front[i]].setting, (Setting{8, 7 + static_cast<int>(i)}));
  EXPECT_TRUE(choice.rows[*choice.best].is_on_front);
}

TEST(Choice, KeepsLimitsWithTheirCertainty) {
  ChoiceRequest request = StandIn();
  request.settings.limits = {{.metric = 2, .most = 1.15, .line = 9}};
  const Choice choice = Choose(request, {});
  EXPECT_EQ(BestOf(request, choice), "x 6, y 7");
  EXPECT_TRUE(choice.clicks[0].leaves_limits);
  EXPECT_EQ(choice.rows[8 * 11 + 7].all_met, 0);
}

TEST(Choice, SaysWhichLimitNobodyMeetsAndByHowMuch) {
  ChoiceRequest request = StandIn();
  request.settings.limits = {{.metric = 2, .most = 0.3, .line = 9}};
  Choice choice = Choose(request, {});
  EXPECT_FALSE(choice.best);
  // The least travel is 0.5.
  EXPECT_THAT(choice.findings, Reports(kLimitUnattainable, 9, {"travel", "at most 300 mm", "x 0", "by 200 mm"}));
  // Of two sides the one that is missed: travel is 1.5 at the most.
  request.settings.limits = {{.metric = 2, .most = 1.9, .least = 1.8, .line = 9}};
  choice = Choose(request, {});
  EXPECT_THAT(choice.findings, Reports(kLimitUnattainable, 9, {"at least 1800 mm", "1900 mm", "x 10", "by 300 mm"}));
  request.settings.limits = {{.metric = 2, .most = 0.8, .line = 9}, {.metric = 0, .most = 1.1, .line = 10}};
  choice = Choose(request, {});
  EXPECT_FALSE(choice.best);
  EXPECT_THAT(choice.findings, Reports(kLimitsContradict, {"90"}));
  const ChoiceAnswer answer{.subject = "run", .confidence = "95 %", .request = request, .choice = choice};
  EXPECT_TRUE(ChoiceJson(answer)["best"].is_null());
  EXPECT_THAT(ChoiceText(answer), testing::HasSubstr("nothing is chosen"));
  EXPECT_EQ(ChoiceFiles(answer).size(), 4U);
}

TEST(Choice, WarnsOfKnobsWithoutEffectAndOfEnds) {
  ChoiceRequest request = StandIn();
  request.spectra = [](std::span<const double> p) {
    MatrixXd metrics(1, 3);
    metrics << 1 / p[0], 1, 1;
    return metrics;
  };
  const Choice choice = Choose(request, {});
  EXPECT_THAT(choice.findings, Reports(kKnobIdle, 3, {"'y'"}));
  EXPECT_THAT(choice.findings, testing::Not(Reports(kKnobIdle, 2)));
  EXPECT_THAT(choice.findings, Reports(kBestAtEnd, 2, {"'x'", "10"}));
}

TEST(Choice, LeavesOutSettingsAndCarsWithoutAnAnswer) {
  ChoiceRequest request = StandIn();
  request.spectra = [](std::span<const double> p) {
    // The best setting, and every setting of a car far off.
    if ((p[0] > 1.25 && p[0] < 1.35) || p[2] > 0.06) throw std::runtime_error("unstable");
    return StandInMetrics(p);
  };
  const Choice choice = Choose(request, {});
  EXPECT_THAT(choice.findings, Reports(kSettingsWithoutRide, {"11 of 121", "x 8, y 0", "unstable"}));
  EXPECT_THAT(choice.findings, Reports(kDrawsLeftOut, {"of 60", "unstable"}));
  ASSERT_TRUE(choice.best);
  EXPECT_NE(choice.rows[*choice.best].setting[0], 8);
  request.spectra = [](std::span<const double>) -> MatrixXd { return MatrixXd::Zero(1, 3); };
  EXPECT_THROW(Choose(request, {}), FaultyInput);
  request.spectra = [](std::span<const double>) -> MatrixXd { throw std::runtime_error("unstable"); };
  EXPECT_THROW(Choose(request, {}), FaultyInput);
}

// As of the damping of a mode that a setting does not have.
TEST(Choice, LeavesOutSettingsOfWhichALimitIsNotKnown) {
  ChoiceRequest request = StandIn(0, 0);
  request.settings.limits = {{.metric = 2, .most = 2, .line = 9}};
  request.spectra = [](std::span<const double> p) {
    MatrixXd metrics = StandInMetrics(p);
    if (p[0] > 1.25 && p[0] < 1.35) metrics(0, 2) = std::nan("");
    return metrics;
  };
  // Engines over time know no limit at all, and are compared nevertheless.
  request.histories = [](std::span<const double> p) {
    MatrixXd metrics = StandInMetrics(p);
    metrics(0, 2) = std::nan("");
    return metrics;
  };
  const Choice choice = Choose(request, {});
  EXPECT_THAT(choice.findings, Reports(kSettingsWithoutRide, {"11 of 121", "x 8, y 0", "line 9"}));
  EXPECT_NE(choice.rows[choice.best.value()].setting[0], 8);
  EXPECT_THAT(choice.findings, testing::Not(Reports(kEngineWithoutRide)));
  EXPECT_FALSE(choice.checks.empty());
}

// The first setting has no answer, which must not count as one that meets all limits.
TEST(Choice, NamesTheSettingThatMeetsLimitsMostOften) {
  ChoiceRequest request = StandIn();
  request.settings.limits = {{.metric = 2, .most = 0.8, .line = 9}, {.metric = 0, .most = 1.1, .line = 10}};
  request.spectra = [](std::span<const double> p) {
    if (p[0] < 0.55) throw std::runtime_error("unstable");
    return StandInMetrics(p);
  };
  EXPECT_THAT(Choose(request, {}).findings,
              AllOf(Reports(kLimitsContradict, {"90"}), testing::Not(Reports(kLimitsContradict, {"x 0, y 0"}))));
}

TEST(Choice, ComparesEnginesAndSaysWhereTheyDisagree) {
  ChoiceRequest request = StandIn();
  request.histories = StandInMetrics;
  request.full = StandInMetrics;
  Choice choice = Choose(request, {});
  EXPECT_THAT(choice.findings, testing::Not(Reports(kEnginesDisagree)));
  // Two numbers of each of three settings, and of the best one.
  EXPECT_EQ(choice.checks.size(), 8U);
  for (const EngineCheck& check : choice.checks) EXPECT_EQ(check.Difference(), 0);
  // An engine that finds the present setting better than the best one.
  request.full = [](std::span<const double> p) {
    MatrixXd metrics = StandInMetrics(p);
    metrics(0, 0) = 1 + std::pow(p[0] - 1, 2) + std::pow(p[1] - 1, 2);
    return metrics;
  };
  choice = Choose(request, {});
  EXPECT_THAT(choice.findings, Reports(kEnginesDisagree, {"1 of 1", "x 8, y 7", "discomfort", "multibody"}));
  EXPECT_THAT(choice.findings, Reports(kEngineOrder, {"multibody", "x 5, y 5"}));
  // By the engine from 1 to 1 + 0.3^2 + 0.2^2, by the spectra from 1 + 0.3^2 + 0.2^2 / 2 to 1.
  const ChoiceAnswer answer{.subject = "run", .confidence = "95 %", .request = request, .choice = choice};
  const double difference = 1.13 - 1 / 1.11;
  std::size_t within = 0;
  for (const RatedSetting& row : choice.rows) within += row.beside_best.mean <= difference ? 1 : 0;
  EXPECT_THAT(ChoiceText(answer), testing::HasSubstr(std::to_string(within - 1) + " other settings are within"));
  request.full = [](std::span<const double>) -> MatrixXd { throw std::runtime_error("diverges"); };
  EXPECT_THAT(Choose(request, {}).findings, Reports(kEngineWithoutRide, {"diverges"}));
}

// Time histories of a car that is best elsewhere than spectra say.
TEST(Choice, FollowsTimeHistoriesWhereSpectraErr) {
  ChoiceRequest request = StandIn();
  request.histories = [](std::span<const double> p) {
    MatrixXd metrics = StandInMetrics(p);
    metrics(0, 0) -= 0.2 * (p[0] - 1);
    return metrics;
  };
  const Choice choice = Choose(request, {});
  // x = 1.4 in place of 1.3.
  EXPECT_EQ(BestOf(request, choice), "x 9, y 7");
  const RatedSetting& best = choice.rows[choice.best.value()];
  // By the histories 1 + 0.1^2 - 0.2 * 0.4 of 1 + 0.3^2 + 0.2^2 / 2, with the doubt of s.
  EXPECT_NEAR(best.change.mean, (1.01 - 0.08) / 1.11 - 1, 0.01);
  const ChoiceAnswer answer{.subject = "run", .confidence = "95 %", .request = request, .choice = choice};
  EXPECT_THAT(ChoiceText(answer), testing::HasSubstr("and the difference between spectra and time histories as of"));
}

SettingsFile TwoKnobs() {
  SettingsFile file;
  file.knobs = {KnobOf("x", 0, 11, 5), KnobOf("y", 1, 11, 5)};
  file.objectives = {{.metric = 0, .weight = 1}};
  return file;
}

EngineCheck CheckOf(std::size_t row, double log_factor) {
  return {.row = row, .objective = 0, .by_spectra = 0.1, .by_engine = 1.1 * std::exp(log_factor) - 1};
}

/// Between settings x apart from the present one.
double Covariance(double s, double t) {
  const auto power = [](double x) { return std::pow(std::abs(x), 1.5); };
  return 0.5 * (power(s) + power(t) - power(s - t));
}

TEST(EngineErrors, AreThoseComparedAndGoOnBeyond) {
  const std::vector<Setting> settings = {{5, 5}, {8, 5}, {9, 5}, {2, 5}, {6, 5}};
  const MatrixXd mean = EngineErrors(TwoKnobs(), settings, 0, {CheckOf(1, 0.03)}, 1).at(0);
  EXPECT_EQ(mean(0, 0), 1);
  EXPECT_NEAR(mean(1, 0), std::exp(0.03), 1e-12);
  // Closed form of one comparison.
  for (const auto& [row, x] : {std::pair(2, 0.4), std::pair(3, -0.3), std::pair(4, 0.1)})
    EXPECT_NEAR(std::log(mean(row, 0)), 0.03 * Covariance(0.3, x) / Covariance(0.3, 0.3), 1e-12);
  EXPECT_TRUE(EngineErrors(TwoKnobs(), settings, 0, {}, 1).empty());
}

// One setting that was compared twice: the other one is Student-distributed about its mean.
TEST(EngineErrors, AreInDoubtWhereNothingWasCompared) {
  const std::vector<Setting> settings = {{5, 5}, {8, 5}, {7, 5}};
  constexpr Index kDraws = 40000;
  const MatrixXd draws =
      EngineErrors(TwoKnobs(), settings, 0, {CheckOf(1, 0.03), CheckOf(1, 0.03)}, kDraws).at(0).array().log();
  EXPECT_EQ(draws.row(0).cwiseAbs().maxCoeff(), 0);
  EXPECT_NEAR((draws.row(1).array() - 0.03).abs().maxCoeff(), 0, 1e-9);
  const double own = Covariance(0.3, 0.3);
  const double across = Covariance(0.2, 0.3);
  EXPECT_NEAR(draws.row(2).mean(), 0.03 * across / own, 1e-3);
  Eigen::VectorXd off = (draws.row(2).array() - 0.03 * across / own).abs().matrix();
  std::nth_element(off.begin(), off.begin() + off.size() / 2, off.end());
  // n = 2 equal comparisons of one setting: d' C^-1 d / n = 0.03^2 / own / 2, m = 5; the median of |t_5| is 0.727.
  const double scale = std::sqrt(0.03 * 0.03 / own / 2 * (Covariance(0.2, 0.2) - across * across / own));
  EXPECT_NEAR(off[off.size() / 2], 0.727 * scale, 0.02 * scale);
}

// The same optimum as all settings have.
TEST(SettingSearch, FindsTheBestOfALargeLattice) {
  ChoiceRequest request = StandIn(0, 0);
  request.settings.knobs = {KnobOf("x", 0, 400, std::nullopt), KnobOf("y", 1, 400, std::nullopt)};
  for (Knob& knob : request.settings.knobs)
    for (std::size_t i = 0; i < knob.positions.size(); ++i) knob.positions[i].values = {0.01 * static_cast<double>(i)};
  const Choice choice = Choose(request, {});
  EXPECT_TRUE(choice.was_searched);
  EXPECT_EQ(choice.lattice, 160000);
  EXPECT_LT(choice.evaluated, 20001);
  EXPECT_EQ(BestOf(request, choice), "x 130, y 120");
  EXPECT_LE(choice.rows.size(), kMostDrawn + 1);
  EXPECT_EQ(choice.rows[choice.present].setting, (Setting{kAsFitted, kAsFitted}));
}

TEST(SettingSearch, KeepsTheBestOfManySettings) {
  ChoiceRequest request = StandIn(0, 0);
  request.settings.knobs = {KnobOf("x", 0, 60, std::nullopt), KnobOf("y", 1, 60, std::nullopt)};
  const SettableCar car{&request.settings, request.spectra};
  const PromisingSettings promising = FindPromising(car, request.fitted, 1, {});
  EXPECT_EQ(promising.evaluated, 3601);
  EXPECT_TRUE(promising.was_cut);
  EXPECT_EQ(promising.settings.size(), kMostDrawn);
  EXPECT_EQ(BestOf(request, Choose(request, {})), "x 13, y 12");
}

}  // namespace
}  // namespace fourpost::choice_test
