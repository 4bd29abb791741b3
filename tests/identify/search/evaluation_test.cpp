#include "identify/search/evaluation.h"

#include <chrono>
#include <cmath>
#include <new>
#include <set>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "tests/rounding.h"

namespace fourpost::evaluation_test {
namespace {

Evaluation Residuals(double a, double b) {
  Evaluation evaluation;
  evaluation.residuals = Eigen::Vector2d(a, b);
  return evaluation;
}

Evaluation Guarded(std::function<Evaluation(const Eigen::VectorXd&)> evaluate) {
  return EvaluateGuarded({Lattice({{"p", 0, 1, 0.1}}), std::move(evaluate)}, Eigen::VectorXd::Constant(1, 0.5));
}

TEST(Evaluation, CostIsTheSumOfSquares) { EXPECT_EQ(Residuals(3, -4).cost(), 25); }

TEST(Evaluation, FailureHasNoCost) {
  EXPECT_THROW(Failed(Failure::kNotConverged, "no equilibrium").cost(), std::logic_error);
}

TEST(Evaluation, GuardLetsGoodResidualsPass) {
  const Evaluation evaluation = Guarded([](const Eigen::VectorXd& p) { return Residuals(p[0], 2); });
  EXPECT_TRUE(evaluation.ok());
  EXPECT_EQ(evaluation.residuals, Eigen::Vector2d(0.5, 2));
}

TEST(Evaluation, GuardTurnsWhatIsNotFiniteIntoAFailure) {
  // 1e200 is finite, its square is not.
  for (const double bad : {std::nan(""), kInfinity, 1e200}) {
    const Evaluation evaluation = Guarded([bad](const Eigen::VectorXd&) { return Residuals(1, bad); });
    EXPECT_EQ(evaluation.failure, Failure::kNotFinite);
    EXPECT_EQ(evaluation.residuals.size(), 0);
  }
}

TEST(Evaluation, GuardTurnsAnExceptionIntoAFailureWithItsWords) {
  const Evaluation known = Guarded([](const Eigen::VectorXd&) -> Evaluation { throw std::runtime_error("no mass"); });
  EXPECT_EQ(known.failure, Failure::kException);
  EXPECT_EQ(known.detail, "no mass");
  const Evaluation unknown = Guarded([](const Eigen::VectorXd&) -> Evaluation { throw 1; });
  EXPECT_EQ(unknown.failure, Failure::kException);
  EXPECT_FALSE(unknown.detail.empty());
  EXPECT_EQ(Guarded({}).failure, Failure::kException);
}

// Nothing is wrong with the values then: stored as their failure it would stay.
TEST(Evaluation, GuardLetsALackOfMemoryPass) {
  EXPECT_THROW(Guarded([](const Eigen::VectorXd&) -> Evaluation { throw std::bad_alloc(); }), std::bad_alloc);
}

TEST(Evaluation, GuardRefusesAViolationThatOrdersNothing) {
  for (const double bad : {std::nan(""), kInfinity, -1.0}) {
    const Evaluation evaluation = Guarded([bad](const Eigen::VectorXd&) { return Infeasible(bad, "too long"); });
    EXPECT_EQ(evaluation.failure, Failure::kException);
    EXPECT_EQ(evaluation.violation, 0);
    EXPECT_NE(evaluation.detail.find("violation"), std::string::npos) << evaluation.detail;
  }
  for (const double good : {0.0, 1e300}) {
    const Evaluation evaluation = Guarded([good](const Eigen::VectorXd&) { return Infeasible(good, "too long"); });
    EXPECT_EQ(evaluation.failure, Failure::kInfeasible);
    EXPECT_EQ(evaluation.violation, good);
  }
}

TEST(Evaluation, GuardEndsAModelThatAsksItsDeadline) {
  const Lattice lattice({{"p", 0, 1, 0.1}});
  const auto hang = [](const Eigen::VectorXd&, const Deadline& deadline) -> Evaluation {
    while (true) deadline.Check();
  };
  const Eigen::VectorXd values = Eigen::VectorXd::Constant(1, 0.5);
  const Evaluation ended = EvaluateGuarded({.lattice = lattice, .evaluate = hang, .deadline_s = 0.01}, values);
  EXPECT_EQ(ended.failure, Failure::kTimedOut);
  EXPECT_EQ(ended.detail, "took longer than 0.01 s");
}

// What was paid for is used, however late it comes.
TEST(Evaluation, GuardKeepsAnEvaluationThatDoesNotAsk) {
  const auto slow = [](const Eigen::VectorXd&, const Deadline& deadline) {
    while (!deadline.HasPassed()) continue;
    return Residuals(1, 2);
  };
  EXPECT_TRUE(EvaluateGuarded({.lattice = Lattice({{"p", 0, 1, 0.1}}), .evaluate = slow, .deadline_s = 1e-3},
                              Eigen::VectorXd::Constant(1, 0.5))
                  .ok());
}

// Waiting is no computing.
TEST(Evaluation, GuardDoesNotCountWhatTheThreadWaits) {
  const auto waiting = [](const Eigen::VectorXd&, const Deadline& deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    deadline.Check();
    return Residuals(1, 2);
  };
  EXPECT_TRUE(EvaluateGuarded({.lattice = Lattice({{"p", 0, 1, 0.1}}), .evaluate = waiting, .deadline_s = 0.1},
                              Eigen::VectorXd::Constant(1, 0.5))
                  .ok());
}

TEST(Evaluation, GuardTurnsNoResidualsIntoAFailure) {
  EXPECT_EQ(Guarded([](const Eigen::VectorXd&) { return Evaluation(); }).failure, Failure::kWrongSize);
}

TEST(Evaluation, GuardKeepsAModelsOwnFailureAndDropsItsResiduals) {
  const Evaluation evaluation = Guarded([](const Eigen::VectorXd&) {
    Evaluation failed = Residuals(1, 2);
    failed.failure = Failure::kInfeasible;
    failed.detail = "negative mass";
    return failed;
  });
  EXPECT_EQ(evaluation.failure, Failure::kInfeasible);
  EXPECT_EQ(evaluation.detail, "negative mass");
  EXPECT_EQ(evaluation.residuals.size(), 0);
}

TEST(Evaluation, FailuresHaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Failure failure : {Failure::kNone, Failure::kNotFinite, Failure::kException, Failure::kNotConverged,
                                Failure::kTimedOut, Failure::kInfeasible, Failure::kWrongSize}) {
    names.insert(FailureName(failure));
  }
  EXPECT_EQ(names.size(), 7u);
  EXPECT_FALSE(names.contains("unknown"));
}

}  // namespace
}  // namespace fourpost::evaluation_test
