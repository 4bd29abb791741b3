#include "identify/uncertainty/model_ranking.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "identify/uncertainty/findings.h"
#include "tests/findings.h"

namespace fourpost::model_ranking_test {
namespace {

using testing::HasSubstr;

FittedModel Model(const std::string& name, double validation, std::size_t parameters, double bic) {
  return {.name = name,
          .fitted_percent = 1,
          .validation_percent = validation,
          .criteria = {.residuals = 100, .parameters = parameters, .aicc = bic, .bic = bic}};
}

std::vector<std::string> Names(const ModelRanking& ranking) {
  std::vector<std::string> names;
  for (const FittedModel& model : ranking.models) names.push_back(model.name);
  return names;
}

// n = 100, S = 50, two parameters and the variance: 100 ln(1/2) + 6 + 24/96; 100 ln(1/2) + 3 ln 100.
TEST(ModelCriteria, AreThoseOfAkaikeAndSchwarz) {
  const ModelCriteria criteria = CriteriaOf(50, 100, 2);
  EXPECT_NEAR(criteria.aicc, 100 * std::log(0.5) + 6 + 0.25, 1e-12);
  EXPECT_NEAR(criteria.bic, 100 * std::log(0.5) + 3 * std::log(100), 1e-12);
  EXPECT_TRUE(std::isnan(CriteriaOf(50, 3, 2).aicc));
}

TEST(ModelRanking, IsByWhatTheFitHasNotSeen) {
  const ModelRanking ranking = Rank({Model("a", 3, 1, 10), Model("b", 1, 3, 30), Model("c", 2, 2, 20)});
  EXPECT_THAT(Names(ranking), testing::ElementsAre("b", "c", "a"));
  EXPECT_THAT(ranking.reason, testing::AllOf(testing::StartsWith("b: "), HasSubstr("1 %; a has the lowest BIC")));
}

TEST(ModelRanking, SaysNothingOfABicThatIsNotTold) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(Rank({Model("a", 3, 1, none), Model("b", 1, 3, none)}).reason,
              testing::AllOf(testing::StartsWith("b: "), testing::EndsWith(", 1 %")));
}

TEST(ModelRanking, TakesTheSimplestOfThoseThatAreAlike) {
  const ModelRanking ranking = Rank({Model("large", 1, 9, 30), Model("small", 1.05, 3, 20), Model("poor", 2, 1, 90)});
  EXPECT_THAT(Names(ranking), testing::ElementsAre("small", "large", "poor"));
  EXPECT_THAT(ranking.reason,
              testing::AllOf(testing::StartsWith("small: "), HasSubstr(", 1 %: 1.05 %; also the lowest BIC")));
}

TEST(ModelRanking, TellsWhichModelIsAsGood) {
  EXPECT_THAT(Rank({Model("a", 2.97, 2, 10), Model("b", 2.98, 2, 30), Model("c", 3.2, 2, 20)}).reason,
              HasSubstr("2.97 %; b is equally good, 2.98 %; "));
  EXPECT_THAT(Rank({Model("a", 2.97, 2, 10), Model("b", 2.98, 3, 30)}).reason, testing::Not(HasSubstr("equally good")));
}

TEST(ModelRanking, IsByBicWithoutValidation) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(Names(Rank({Model("a", none, 1, 10), Model("b", none, 3, 5)})), testing::ElementsAre("b", "a"));
}

TEST(ModelRanking, TellsThatOneRunIsNoComparison) {
  const ModelRanking one = Rank({Model("a", 3, 1, 10)});
  EXPECT_THAT(one.warnings, Reports(kRankedAlone, 0));
  EXPECT_EQ(one.warnings.items().size(), 1u) << one.warnings.Format();
  EXPECT_THAT(one.reason, testing::AllOf(testing::StartsWith("a: "), HasSubstr("3 %")));
  EXPECT_EQ(Rank({Model("a", 3, 1, 10), Model("b", 4, 1, 10)}).warnings.Format(), "");
}

TEST(ModelRanking, WarnsOfFitsThatAreNotWhatTheyCouldBe) {
  FittedModel cut = Model("cut", 3, 1, 10);
  cut.termination = "interrupted";
  FittedModel open = Model("open", 4, 1, 10);
  open.termination = "not_converged";
  open.explains = false;
  const Diagnostics warnings = Rank({cut, open}).warnings;
  EXPECT_THAT(warnings, Reports(kRankedInterrupted, 0, {"cut"}));
  EXPECT_THAT(warnings, Reports(kRankedNotConverged, 0, {"open"}));
  EXPECT_THAT(warnings, Reports(kRankedUnexplained, 0, {"open"}));
  EXPECT_EQ(warnings.items().size(), 3u) << warnings.Format();
}

}  // namespace
}  // namespace fourpost::model_ranking_test
