#include "identify/refine/several_starts.h"

#include <cmath>
#include <initializer_list>

#include <gtest/gtest.h>

namespace fourpost::several_starts_test {
namespace {

// Minima at x = 2 with a cost of 0 and near x = -2 with a cost near 4; fails beyond 4.
class RefineFromSeveral : public testing::Test {
 protected:
  static Evaluation TwoMinima(const Eigen::VectorXd& p) {
    if (p[0] > 4) return Failed(Failure::kNotConverged, "");
    Evaluation evaluation;
    evaluation.residuals = Eigen::Vector2d(p[0] * p[0] - 4, 0.5 * (p[0] - 2));
    return evaluation;
  }

  static std::vector<Eigen::VectorXd> Starts(std::initializer_list<double> values) {
    std::vector<Eigen::VectorXd> starts;
    for (const double value : values) starts.push_back(Eigen::VectorXd::Constant(1, value));
    return starts;
  }

  Archive archive_{{Lattice({{"x", -5, 5, 0.1}}), TwoMinima}};
};

TEST_F(RefineFromSeveral, OneThatWasStoppedCountsForNothing) {
  MultiStartResult result = RefineFrom(archive_, Starts({3, 1}), {}, [asked = 0]() mutable { return ++asked > 2; });
  ASSERT_EQ(result.runs.size(), 1u);
  EXPECT_EQ(result.runs[0].end, RefineEnd::kStopped);
  EXPECT_EQ(result.best, 0);
  EXPECT_EQ(result.ended, 0);
  EXPECT_EQ(result.agreeing, 0);
  result = RefineFrom(archive_, Starts({3, 1}));
  EXPECT_EQ(result.ended, 2);
  EXPECT_EQ(result.agreeing, 2);
}

TEST_F(RefineFromSeveral, OneThatHeadsForTooHighACostIsGivenUp) {
  RefineOptions options;
  options.give_up_above = 1;
  const RefineResult high = Refine(archive_, Starts({-4}).front(), options);
  EXPECT_EQ(high.end, RefineEnd::kGivenUp);
  EXPECT_FALSE(high.has_ended());
  EXPECT_GE(high.iterations, 3);
  EXPECT_LT(high.evaluations, Refine(archive_, Starts({-4}).front()).evaluations);
  const RefineResult low = Refine(archive_, Starts({4}).front(), options);
  EXPECT_EQ(low.end, RefineEnd::kConverged);
  EXPECT_LT(low.cost, 1e-12);
}

TEST_F(RefineFromSeveral, TheBestWinsAndThoseThatAgreeAreCounted) {
  const MultiStartResult result = RefineFrom(archive_, Starts({-3, 5, 3, -1, 1}));
  ASSERT_EQ(result.runs.size(), 5u);
  EXPECT_EQ(result.agreeing, 2);
  EXPECT_TRUE(result.best == 2 || result.best == 4);
  EXPECT_TRUE(result.runs[2].agrees);
  EXPECT_FALSE(result.runs[0].agrees);
  EXPECT_NEAR(result.runs[2].values[0], 2, 1e-7);                         // step_tolerance times the range
  EXPECT_NEAR(result.runs[0].values[0], result.runs[3].values[0], 1e-4);  // root of cost_tolerance
  EXPECT_EQ(result.runs[1].end, RefineEnd::kStartFailed);
}

TEST_F(RefineFromSeveral, CountsAgreementAtACostThatIsNotZeroToo) {
  const MultiStartResult result = RefineFrom(archive_, Starts({-3, -1, -2.5}));
  EXPECT_EQ(result.agreeing, 3);
  EXPECT_GT(result.runs[0].cost, 3);
}

/// Two minima, at x = 2 of cost 99 and near -2 of (2 depth)^2 more; 101 residuals.
int AgreeingAt(double depth) {
  const auto two_minima = [depth](const Eigen::VectorXd& p) {
    Evaluation evaluation;
    evaluation.residuals = Eigen::VectorXd::Ones(101);
    evaluation.residuals[0] = p[0] * p[0] - 4;
    evaluation.residuals[1] = 0.5 * depth * (p[0] - 2);
    return evaluation;
  };
  Archive archive({Lattice({{"x", -5, 5, 0.1}}), two_minima});
  return RefineFrom(archive, {Eigen::VectorXd::Constant(1, 3), Eigen::VectorXd::Constant(1, -3)}).agreeing;
}

// A unit of chi-square is 99 / (101 - 1): a tenth of it is (2 x 0.157)^2.
TEST(RefineAgreement, IsByWhatTheDataCanTell) {
  EXPECT_EQ(AgreeingAt(0.15), 2);
  EXPECT_EQ(AgreeingAt(0.165), 1);
}

TEST_F(RefineFromSeveral, WithoutAGoodStartThereIsNoBest) {
  EXPECT_EQ(RefineFrom(archive_, {}).best, -1);
  const MultiStartResult result = RefineFrom(archive_, Starts({5, 4.5}));
  EXPECT_EQ(result.best, -1);
  EXPECT_EQ(result.agreeing, 0);
  EXPECT_EQ(result.runs.size(), 2u);
}

TEST_F(RefineFromSeveral, AfterAStopTheRestIsLeftOut) {
  int asked = 0;
  const MultiStartResult result = RefineFrom(archive_, Starts({3, 2.5, 1}), {}, [&] { return ++asked > 4; });
  ASSERT_EQ(result.runs.size(), 1u);
  EXPECT_EQ(result.runs[0].end, RefineEnd::kStopped);
  EXPECT_EQ(result.best, 0);
}

/// 400 residuals of a decay with what it lacks, a wave; or every `step`-th of them.
Evaluation Decay(const Eigen::VectorXd& p, int step) {
  Evaluation evaluation;
  evaluation.residuals.resize(400 / step);
  for (int i = 0; i < evaluation.residuals.size(); ++i) {
    const double t = 0.01 * step * i;
    evaluation.residuals[i] = 100 * (p[0] * std::exp(-p[1] * t) - 2 * std::exp(-1.5 * t) + 0.01 * std::sin(40 * t));
  }
  return evaluation;
}

class LedByCoarseResiduals : public testing::Test {
 protected:
  static Archive Of(int step) {
    return Archive({Lattice({{"a", 0.1, 10, 0.1}, {"k", 0.1, 10, 0.1}}),
                    [step](const Eigen::VectorXd& p) { return Decay(p, step); }});
  }

  const std::vector<Eigen::VectorXd> starts_ = {Eigen::Vector2d(0.5, 4), Eigen::Vector2d(9, 9),
                                                Eigen::Vector2d(5, 0.2)};
  Archive archive_ = Of(1);
  Archive coarse_ = Of(4);
};

// The nearness of an end is a tenth of a deviation, so two ends are a fifth of one apart at the most: the cost differs
// by a hundredth of a unit of chi-square.
TEST_F(LedByCoarseResiduals, EndsWhereItEndsWithoutThem) {
  Archive alone = Of(1);
  const MultiStartResult expected = RefineFrom(alone, starts_);
  const MultiStartResult led = RefineFrom(archive_, starts_, {}, {}, &coarse_);
  ASSERT_GE(led.best, 0);
  const RefineResult& best = led.runs[static_cast<std::size_t>(led.best)];
  const RefineResult& reference = expected.runs[static_cast<std::size_t>(expected.best)];
  EXPECT_EQ(best.end, RefineEnd::kConverged);
  EXPECT_NEAR(best.cost, reference.cost, 0.01 * reference.cost / 398);
  EXPECT_EQ(led.agreeing, 3);
  EXPECT_EQ(led.ended, 3);
}

TEST_F(LedByCoarseResiduals, PaysForFewOfAll) {
  Archive alone = Of(1);
  RefineFrom(alone, starts_);
  RefineFrom(archive_, starts_, {}, {}, &coarse_);
  EXPECT_LT(archive_.counts().paid, alone.counts().paid / 2);
}

TEST_F(LedByCoarseResiduals, OnesOfOneCoarseOptimumAreOne) {
  const MultiStartResult led = RefineFrom(archive_, starts_, {}, {}, &coarse_);
  ASSERT_EQ(led.runs.size(), 3u);
  for (std::size_t i : {1u, 2u}) {
    EXPECT_EQ(led.runs[i].end, RefineEnd::kKnown) << i;
    EXPECT_EQ(led.runs[i].values, led.runs[0].values) << i;
    EXPECT_EQ(led.runs[i].evaluations, 1) << i;  // of the start
    EXPECT_GT(led.runs[i].coarse_evaluations, 1) << i;
    EXPECT_DOUBLE_EQ(led.runs[i].start_cost, Decay(starts_[i], 1).residuals.squaredNorm()) << i;
  }
}

// Coarse residuals whose optimum is elsewhere cost evaluations and change nothing.
TEST_F(LedByCoarseResiduals, AreLeftWhereTheyLeadUp) {
  Archive elsewhere({Lattice({{"a", 0.1, 10, 0.1}, {"k", 0.1, 10, 0.1}}), [](const Eigen::VectorXd& p) {
                       Evaluation evaluation;
                       evaluation.residuals = 10 * (p - Eigen::Vector2d(9.5, 0.11));
                       return evaluation;
                     }});
  const std::vector<Eigen::VectorXd> start = {starts_[0]};
  Archive alone = Of(1);
  const RefineResult expected = RefineFrom(alone, start).runs[0];
  const RefineResult led = RefineFrom(archive_, start, {}, {}, &elsewhere).runs[0];
  EXPECT_EQ(led.values, expected.values);
  EXPECT_GT(led.coarse_evaluations, 0);
}

TEST_F(LedByCoarseResiduals, FailWithoutHarm) {
  Archive failing({Lattice({{"a", 0.1, 10, 0.1}, {"k", 0.1, 10, 0.1}}),
                   [](const Eigen::VectorXd&) { return Failed(Failure::kNotConverged, ""); }});
  Archive alone = Of(1);
  const RefineResult led = RefineFrom(archive_, starts_, {}, {}, &failing).runs[0];
  EXPECT_EQ(led.values, RefineFrom(alone, starts_).runs[0].values);
  EXPECT_EQ(led.coarse_evaluations, 1);
}

TEST_F(LedByCoarseResiduals, PayForEachPointOnce) {
  const MultiStartResult led = RefineFrom(archive_, starts_, {}, {}, &coarse_);
  std::int64_t paid = 0;
  std::int64_t coarse = 0;
  for (const RefineResult& run : led.runs) {
    paid += run.evaluations;
    coarse += run.coarse_evaluations;
  }
  EXPECT_EQ(paid, archive_.counts().paid);
  EXPECT_EQ(coarse, coarse_.counts().paid);
}

TEST_F(LedByCoarseResiduals, StopAtOnce) {
  int asked = 0;
  const MultiStartResult led = RefineFrom(
      archive_, starts_, {}, [&] { return ++asked > 2; }, &coarse_);
  ASSERT_EQ(led.runs.size(), 1u);
  EXPECT_EQ(led.runs[0].end, RefineEnd::kStopped);
  EXPECT_EQ(led.runs[0].values, starts_[0]);
  EXPECT_EQ(led.runs[0].evaluations, 1);  // of the start
}

TEST_F(LedByCoarseResiduals, SharesTheLimitOfIterations) {
  RefineOptions options;
  options.max_iterations = 4;
  for (const RefineResult& run : RefineFrom(archive_, starts_, options, {}, &coarse_).runs)
    EXPECT_LE(run.iterations, 5);  // one is always left
}

// Minima of all residuals at 2 and, higher, near -2; the coarse ones lead to -2 from everywhere.
TEST(CoarseResiduals, ThatLeadToAPoorOptimumLoseNoBetterOne) {
  const Lattice lattice({{"x", -5, 5, 0.1}});
  Archive archive({lattice, [](const Eigen::VectorXd& p) {
                     Evaluation evaluation;
                     evaluation.residuals = Eigen::Vector2d(p[0] * p[0] - 4, 0.5 * (p[0] - 2));
                     return evaluation;
                   }});
  Archive coarse({lattice, [](const Eigen::VectorXd& p) {
                    Evaluation evaluation;
                    evaluation.residuals = Eigen::VectorXd::Constant(1, p[0] + 2);
                    return evaluation;
                  }});
  const std::vector<Eigen::VectorXd> starts = {Eigen::VectorXd::Constant(1, -3), Eigen::VectorXd::Constant(1, 2.1)};
  const MultiStartResult led = RefineFrom(archive, starts, {}, {}, &coarse);
  ASSERT_EQ(led.best, 1);
  EXPECT_NEAR(led.runs[1].values[0], 2, 1e-6);  // step_tolerance times the range
}

}  // namespace
}  // namespace fourpost::several_starts_test
