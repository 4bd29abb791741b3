#include "identify/model_ranking.h"

#include <cmath>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>

#include "tests/temporary_folder.h"

namespace fourpost {
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
  EXPECT_EQ(ranking.reason,
            "b: of all models it misses least of what it was not fitted to, 1 %; the least BIC has a, which the fitted "
            "recordings favour and the others do not: trust the others");
}

TEST(ModelRanking, SaysNothingOfABicThatIsNotTold) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Rank({Model("a", 3, 1, none), Model("b", 1, 3, none)}).reason,
            "b: of all models it misses least of what it was not fitted to, 1 %");
}

TEST(ModelRanking, TakesTheSimplestOfThoseThatAreAlike) {
  const ModelRanking ranking = Rank({Model("large", 1, 9, 30), Model("small", 1.05, 3, 20), Model("poor", 2, 1, 90)});
  EXPECT_THAT(Names(ranking), testing::ElementsAre("small", "large", "poor"));
  EXPECT_THAT(ranking.reason, HasSubstr("small: it has the fewest parameters of those within 10 % of the least "
                                        "validation error, 1 %: 1.05 %; its BIC is the least, too"));
}

TEST(ModelRanking, IsByBicWithoutValidation) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(Names(Rank({Model("a", none, 1, 10), Model("b", none, 3, 5)})), testing::ElementsAre("b", "a"));
}

class FittedModelsTest : public testing::Test {
 protected:
  void Write(const std::string& run, const std::string& text) {
    std::filesystem::create_directory(folder_.path() / run);
    std::ofstream(folder_.path() / run / "result.json") << text;
  }
  std::vector<FittedModel> Read() {
    return ReadFittedModels({folder_.path() / "a", folder_.path() / "b"}, diagnostics_);
  }

  TemporaryFolder folder_;
  Diagnostics diagnostics_;
  const std::string good_ = R"({"study": "model1.yaml", "termination": "converged",
    "channels": [{"recording": "sweep", "name": "force", "nmse_percent": 2}],
    "validation": [{"recording": "s1", "name": "force", "nmse_percent": 3},
                   {"recording": "s2", "name": "force", "nmse_percent": 5}],
    "criteria": {"residuals": 100, "parameters": 2, "aicc": 7, "bic": 8}})";
};

TEST_F(FittedModelsTest, AreReadFromTheirRuns) {
  Write("a", good_);
  Write("b", Replace(good_, "model1", "model2"));
  const std::vector<FittedModel> models = Read();
  ASSERT_EQ(models.size(), 2) << diagnostics_.Format();
  EXPECT_EQ(models[0].name, "model1");
  EXPECT_EQ(models[1].name, "model2");
  EXPECT_EQ(models[0].fitted_percent, 2);
  EXPECT_EQ(models[0].validation_percent, 4);
  EXPECT_EQ(models[0].criteria.bic, 8);
}

TEST_F(FittedModelsTest, TellThatTheirFitsDidNotEnd) {
  Write("a", good_);
  Write("b", Replace(Replace(good_, "model1", "model2"), "converged", "interrupted"));
  const ModelRanking ranking = Rank(Read());
  ASSERT_EQ(ranking.remarks.size(), 1) << diagnostics_.Format();
  EXPECT_THAT(ranking.remarks[0], HasSubstr("The fit of model2 was interrupted: "));
}

TEST(ModelRanking, TellsThatOneRunIsNoComparison) {
  const ModelRanking one = Rank({Model("a", 3, 1, 10)});
  EXPECT_THAT(one.remarks, testing::ElementsAre(HasSubstr("the only run")));
  EXPECT_EQ(one.reason, "a: misses 3 % of what it was not fitted to");
  EXPECT_THAT(Rank({Model("a", 3, 1, 10), Model("b", 4, 1, 10)}).remarks, testing::IsEmpty());
}

TEST_F(FittedModelsTest, MustBeOfTheSameRecordings) {
  Write("a", good_);
  Write("b", Replace(good_, "s2", "s3"));
  Read();
  EXPECT_THAT(diagnostics_.Format(), HasSubstr("was fitted or validated with other recordings"));
}

TEST_F(FittedModelsTest, MustBeOfBenches) {
  Write("a", R"({"study": "car.yaml", "channels": []})");
  Write("b", "nonsense");
  Read();
  EXPECT_EQ(diagnostics_.items().size(), 2);
  EXPECT_THAT(diagnostics_.Format(), HasSubstr("is not the result of a fit to bench recordings"));
}

}  // namespace
}  // namespace fourpost
