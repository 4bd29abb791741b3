#include "identify/refine/refine.h"
#include "identify/refine/several_starts.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/LU>

#include "identify/refine/fit_variables.h"
#include "identify/search/draws.h"
#include "identify/search/dvhde.h"
#include "identify/search/dvhde_operators.h"
#include "identify/uncertainty/covariance.h"
#include "tests/identify/test_problems.h"

namespace fourpost::refine_test {
namespace {

using testing::StrEq;
using testing::ThrowsMessage;

// 100 (a exp(-k t) - 2 exp(-1.5 t)) at t = 0, 0.1, ... 1.9.
constexpr double kWeight = 100;
Evaluation Decay(const Eigen::VectorXd& p) {
  Evaluation evaluation;
  evaluation.residuals.resize(20);
  for (int i = 0; i < 20; ++i) {
    const double t = 0.1 * i;
    evaluation.residuals[i] = kWeight * (p[0] * std::exp(-p[1] * t) - 2 * std::exp(-1.5 * t));
  }
  return evaluation;
}
const Eigen::Vector2d kDecayTruth(2, 1.5);
const Eigen::Vector2d kDecayStart(0.5, 4);

Lattice DecayLattice(double lowest_rate = 0.1) { return Lattice({{"a", 0.1, 10, 0.1}, {"k", lowest_rate, 10, 0.1}}); }

// Decay, where it can be evaluated.
Problem DecayWhere(std::function<bool(const Eigen::VectorXd&)> possible) {
  return {DecayLattice(), [=](const Eigen::VectorXd& p) {
            Evaluation evaluation = Decay(p);
            if (!possible(p)) evaluation.residuals[7] = std::nan("");
            return evaluation;
          }};
}

// A wheel station: sprung and unsprung mass, spring, tyre and damper rates.
const Eigen::VectorXd kStationTruth = (Eigen::VectorXd(5) << 200, 22, 15000, 230000, 1500).finished();
constexpr int kFrequencies = 30;

Lattice StationLattice(double heaviest_wheel = 90) {
  return Lattice({{"ms", 50, 800, 0.1},
                  {"mu", 5, heaviest_wheel, 0.1},
                  {"ks", 4000, 60000, 10},
                  {"kt", 60000, 900000, 10},
                  {"d", 400, 6000, 1}});
}

// Motion of the body and force of the tyre per motion of the ground at 0.5 to 15 Hz.
Eigen::VectorXcd StationResponse(const Eigen::VectorXd& p) {
  using Complex = std::complex<double>;
  Eigen::VectorXcd response(2 * kFrequencies);
  for (int i = 0; i < kFrequencies; ++i) {
    const double w = 2 * std::numbers::pi * 0.5 * std::pow(30, i / (kFrequencies - 1.0));
    const Complex strut(p[2], w * p[4]);
    const Complex body = strut - w * w * p[0];
    const Complex wheel = strut + p[3] - w * w * p[1];
    const Complex determinant = body * wheel - strut * strut;
    response[2 * i] = strut * p[3] / determinant;
    response[2 * i + 1] = p[3] * (1.0 - body * p[3] / determinant);
  }
  return response;
}

// Sum of 12 uniform numbers: mean 0, variance 1.
double NearlyNormal(Draws& draws) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += draws.Uniform();
  return sum;
}

// Against responses with 1 % noise on each part; seed 0 is free of noise.
Problem StationProblem(std::uint64_t seed = 0, double heaviest_wheel = 90) {
  const Eigen::VectorXcd exact = StationResponse(kStationTruth);
  const Eigen::VectorXd sd = 0.01 * exact.cwiseAbs();
  Eigen::VectorXcd data = exact;
  Draws draws(seed, DrawPurpose::kTrial, 0, 0);
  for (Eigen::Index i = 0; i < data.size() && seed > 0; ++i) {
    data[i] += sd[i] * std::complex<double>(NearlyNormal(draws), NearlyNormal(draws));
  }
  return {StationLattice(heaviest_wheel), [=](const Eigen::VectorXd& p) {
            const Eigen::VectorXcd difference = ((StationResponse(p) - data).array() / sd.array()).matrix();
            Evaluation evaluation;
            evaluation.residuals.resize(2 * difference.size());
            evaluation.residuals << difference.real(), difference.imag();
            return evaluation;
          }};
}

std::vector<Eigen::VectorXd> RandomStarts(const Lattice& lattice, int count) {
  Draws draws(1, DrawPurpose::kInitial, 0, 0);
  std::vector<Eigen::VectorXd> starts;
  for (int i = 0; i < count; ++i) starts.push_back(lattice.Values(RandomPoint(lattice, draws)));
  return starts;
}

double LargestRelativeError(const Eigen::VectorXd& values, const Eigen::VectorXd& truth) {
  return ((values - truth).array() / truth.array()).abs().maxCoeff();
}

TEST(Refine, SolvesLinearLeastSquares) {
  Draws draws(1, DrawPurpose::kTrial, 0, 0);
  const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(30, 3, [&] { return 2 * draws.Uniform() - 1; });
  const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(30, [&] { return 2 * draws.Uniform() - 1; });
  const Lattice lattice({{"x", -5, 5, 0.1}, {"y", -5, 5, 0.1}, {"z", -5, 5, 0.1}});
  Archive archive({lattice, [&](const Eigen::VectorXd& p) {
                     Evaluation evaluation;
                     evaluation.residuals = a * p - b;
                     return evaluation;
                   }});
  const RefineResult result = Refine(archive, Eigen::Vector3d(4, -3, 2));
  const Eigen::VectorXd exact = (a.transpose() * a).inverse() * a.transpose() * b;
  EXPECT_EQ(result.end, RefineEnd::kConverged);
  EXPECT_NEAR(result.cost, (a * exact - b).squaredNorm(), 1e-8 * result.cost);  // cost_tolerance
  // A cost within that of the least is this far off at most, in units of the least singular value, above 1 here.
  EXPECT_LT((result.values - exact).norm(), std::sqrt(1e-8 * result.cost));
  EXPECT_DOUBLE_EQ(result.start_cost, (a * Eigen::Vector3d(4, -3, 2) - b).squaredNorm());
  EXPECT_EQ(result.cost, result.residuals.squaredNorm());
  // Parameters are ten times their share of the range; differences of a linear function carry only rounding, epsilon
  // over step.
  EXPECT_TRUE(result.jacobian.isApprox(10 * a, 1e-10));
}

TEST(Refine, SolvesNonlinearLeastSquares) {
  Archive archive({DecayLattice(), Decay});
  const RefineResult result = Refine(archive, kDecayStart);
  EXPECT_EQ(result.end, RefineEnd::kConverged);
  // Convergence to a zero of the residuals is quadratic: a last step below step_tolerance leaves less.
  EXPECT_LT(LargestRelativeError(result.values, kDecayTruth), 1e-8);
  EXPECT_GT(result.start_cost, 1e5);
  EXPECT_EQ(result.evaluations, archive.counts().paid);
}

TEST(Refine, ReturnsTheJacobianWhereItEnded) {
  Archive archive({DecayLattice(), Decay});
  const RefineResult result = Refine(archive, kDecayStart);
  // By ln a: the decay itself; by ln k: -k t times it.
  for (int i = 0; i < 20; ++i) {
    const double decay = kWeight * result.values[0] * std::exp(-result.values[1] * 0.1 * i);
    // Central differences: step^2 / 6 of the third derivative, which is below 30 times the largest residual.
    EXPECT_NEAR(result.jacobian(i, 0), decay, 5 * 1e-8 * 2 * kWeight);
    EXPECT_NEAR(result.jacobian(i, 1), -result.values[1] * 0.1 * i * decay, 5 * 1e-8 * 2 * kWeight);
  }
}

TEST(Refine, StaysAtAnOptimum) {
  Archive archive(StationProblem());
  const RefineResult result = Refine(archive, kStationTruth);
  EXPECT_EQ(result.end, RefineEnd::kConverged);
  EXPECT_LT(LargestRelativeError(result.values, kStationTruth), 1e-8);  // step_tolerance
  EXPECT_EQ(result.iterations, 0);
}

// The rate wants to be 1.5 and may not be below 2; then a = sum(y e) / sum(e^2) with e = exp(-2 t), y = 2 exp(-1.5 t).
TEST(Refine, FindsTheOptimumOnABound) {
  double ye = 0;
  double ee = 0;
  for (int i = 0; i < 20; ++i) {
    const double t = 0.1 * i;
    ye += 2 * std::exp(-3.5 * t);
    ee += std::exp(-4 * t);
  }
  const Eigen::Vector2d optimum(ye / ee, 2);
  const double least = Decay(optimum).cost();
  for (const Eigen::VectorXd& start : RandomStarts(DecayLattice(2), 20)) {
    Archive archive({DecayLattice(2), Decay});
    const RefineResult result = Refine(archive, start);
    EXPECT_EQ(result.end, RefineEnd::kConverged);
    EXPECT_NEAR(result.cost, least, 1e-8 * least);  // cost_tolerance
    EXPECT_EQ(result.values[1], 2);
    // What that leaves for a: the cost rises by kWeight^2 ee (a - optimum)^2.
    EXPECT_NEAR(result.values[0], optimum[0], std::sqrt(1e-8 * least / ee) / kWeight);
    EXPECT_LT(result.evaluations, 100);
  }
}

TEST(Refine, FindsTheOptimumInACornerOfTheBounds) {
  // Both would have to grow.
  Archive archive({Lattice({{"a", 0.1, 1, 0.1}, {"k", 2, 10, 0.1}}), Decay});
  const RefineResult result = Refine(archive, kDecayStart);
  EXPECT_EQ(result.end, RefineEnd::kConverged);
  EXPECT_EQ(result.values, Eigen::Vector2d(1, 2));
}

TEST(Refine, LeavesABoundThatItNeedNotKeep) {
  Archive archive({DecayLattice(), Decay});
  const RefineResult result = Refine(archive, Eigen::Vector2d(0.1, 10));
  EXPECT_LT(LargestRelativeError(result.values, kDecayTruth), 1e-8);  // as above
}

// The wheel may not be heavier than 20 kg and is 22 kg.
TEST(Refine, FindsTheSameBoundedOptimumFromAnywhere) {
  Archive archive(StationProblem(0, 20));
  const MultiStartResult result = RefineFrom(archive, RandomStarts(archive.lattice(), 30));
  EXPECT_EQ(result.agreeing, 30);
  EXPECT_EQ(result.runs.front().end, RefineEnd::kConverged);
  for (const RefineResult& run : result.runs) {
    EXPECT_TRUE(run.end == RefineEnd::kConverged || run.end == RefineEnd::kKnown);
    EXPECT_EQ(run.values[1], 20);
  }
  EXPECT_LT(archive.counts().paid, 30 * 120);
}

// All others turn back before they come to where the first has been, at less than its price.
TEST(Refine, EndsWhereItMeetsAKnownOptimum) {
  Archive archive(StationProblem(1));
  const MultiStartResult result = RefineFrom(archive, RandomStarts(archive.lattice(), 10));
  EXPECT_EQ(result.agreeing, 10);
  const RefineResult& first = result.runs.front();
  std::int64_t alone = 0;
  for (std::size_t i = 1; i < result.runs.size(); ++i) {
    const RefineResult& run = result.runs[i];
    EXPECT_EQ(run.end, RefineEnd::kKnown);
    EXPECT_EQ(run.met, 0u);
    EXPECT_EQ(run.values, first.values);
    Archive own(StationProblem(1));
    alone += Refine(own, RandomStarts(own.lattice(), 10)[i]).evaluations;
  }
  EXPECT_LT(archive.counts().paid - first.evaluations, alone);
}

// Closed form: one residual of slope 2 and 4 degrees of freedom, so that the unit of chi-square is 1.
TEST(KnownOptima, AreMetNearThemAndAtTheirHeight) {
  KnownOptima known;
  known.Add({.x = Eigen::VectorXd::Constant(1, 10), .cost = 4, .normal = Eigen::MatrixXd::Constant(1, 1, 4)});
  const auto met = [&](double x, double cost, double gain) {
    const Eigen::VectorXd at = Eigen::VectorXd::Constant(1, x);
    return known.MetBy({.x = at, .cost = cost, .full_gain = gain, .freedom = 4}, 0.1).has_value();
  };
  EXPECT_TRUE(met(11, 8, 4));
  EXPECT_TRUE(met(11.49, 12.9, 8.9));
  EXPECT_FALSE(met(11.51, 12.9, 8.9));  // more than three deviations of 0.5
  EXPECT_FALSE(met(11, 8, 4.2));        // it goes lower
  EXPECT_FALSE(met(11, 8, 3.8));        // or another way
  EXPECT_FALSE(met(10, 3.95, 0));       // it is better
  const auto is_one = [&](double x, double cost) {
    return known.OneWith(Eigen::VectorXd::Constant(1, x), cost, 4, 0.1).has_value();
  };
  EXPECT_TRUE(is_one(11.49, 4.09));
  EXPECT_TRUE(is_one(10, 3.91));
  EXPECT_FALSE(is_one(11.51, 4));
  EXPECT_FALSE(is_one(10, 3.89));
}

TEST(Refine, FindsTheSameOptimumFromAnywhere) {
  Archive archive(StationProblem());
  const MultiStartResult result = RefineFrom(archive, RandomStarts(archive.lattice(), 30));
  EXPECT_EQ(result.agreeing, 30);
  // Zero residuals: see SolvesNonlinearLeastSquares; the norm of the variables is below 20.
  for (const RefineResult& run : result.runs) EXPECT_LT(LargestRelativeError(run.values, kStationTruth), 20 * 1e-8);
}

TEST(Refine, EvaluatesWithinTheBoundsOnly) {
  const Lattice lattice = StationLattice(20);
  const Problem problem = StationProblem(0, 20);
  int outside = 0;
  Archive archive({lattice, [&](const Eigen::VectorXd& p) {
                     for (std::size_t j = 0; j < lattice.size(); ++j) {
                       const double value = p[static_cast<Eigen::Index>(j)];
                       outside += value < lattice.axes()[j].lower || value > lattice.axes()[j].upper;
                     }
                     return problem.evaluate(p);
                   }});
  RefineFrom(archive, RandomStarts(lattice, 5));
  EXPECT_EQ(outside, 0);
}

TEST(Refine, PaysForOneJacobianAndOneStepAnIteration) {
  Archive archive(StationProblem(1));
  const RefineResult result = Refine(archive, 1.1 * kStationTruth);
  // No step is refused from so near: the start, its Jacobian, and per iteration a step and its Jacobian; the Jacobian
  // after the last step is not needed.
  EXPECT_EQ(result.end, RefineEnd::kConverged);
  EXPECT_GE(result.evaluations, 1 + 10 + result.iterations * 11);
  EXPECT_LE(result.evaluations, 1 + 10 + (result.iterations + 1) * 11);
}

TEST(Refine, BacksOffFromWhatCannotBeEvaluated) {
  // The way from the start leads past this border, the optimum lies inside it.
  Archive archive(DecayWhere([](const Eigen::VectorXd& p) { return p[0] < 2.2 && p[1] > 1.3; }));
  const RefineResult result = Refine(archive, Eigen::Vector2d(0.2, 8));
  EXPECT_EQ(result.end, RefineEnd::kConverged);
  EXPECT_LT(LargestRelativeError(result.values, kDecayTruth), 1e-8);  // as above
  EXPECT_GT(archive.counts().failed(), 0);
}

// The optimum cannot be evaluated: near the border steps become short, which is no convergence.
TEST(Refine, DoesNotCallABorderOfFailuresAnOptimum) {
  for (const Eigen::VectorXd& start : RandomStarts(DecayLattice(2.5), 20)) {
    Archive archive(DecayWhere([](const Eigen::VectorXd& p) { return p[1] > 2; }));
    const RefineResult result = Refine(archive, start);
    EXPECT_EQ(result.end, RefineEnd::kFailed);
    EXPECT_EQ(result.message, "a residual is not finite");
    EXPECT_GT(result.values[1], 2);
    EXPECT_TRUE(result.has_cost());
    EXPECT_EQ(result.cost, Decay(result.values).cost());
    EXPECT_LE(result.cost, result.start_cost);
    EXPECT_TRUE(result.residuals.allFinite());
    EXPECT_TRUE(result.jacobian.allFinite());
  }
}

// After each number of evaluations in turn everything fails but the start: whatever has been reached stays.
TEST(Refine, KeepsWhatItReachedWhenNoMoreCanBeEvaluated) {
  double last_cost = Decay(kDecayStart).cost();
  for (int good = 1; good < 60; ++good) {
    int calls = 0;
    Archive archive(DecayWhere(
        [&](const Eigen::VectorXd& p) { return ++calls <= good || LargestRelativeError(p, kDecayStart) < 1e-12; }));
    const RefineResult result = Refine(archive, kDecayStart);
    EXPECT_EQ(result.end, RefineEnd::kFailed);
    EXPECT_FALSE(result.message.empty());
    EXPECT_LE(result.cost, last_cost);
    EXPECT_NEAR(result.cost, Decay(result.values).cost(), 1e-12 * result.cost);  // rounding
    last_cost = result.cost;
  }
  EXPECT_LT(last_cost, 0.1 * Decay(kDecayStart).cost());
}

TEST(Refine, SaysWhyTheStartFailed) {
  Archive archive({DecayLattice(), [](const Eigen::VectorXd&) { return Failed(Failure::kNotConverged, "no rest"); }});
  const RefineResult result = Refine(archive, kDecayStart);
  EXPECT_EQ(result.end, RefineEnd::kStartFailed);
  EXPECT_EQ(result.message, "no rest");
  EXPECT_FALSE(result.has_cost());
  EXPECT_EQ(result.values, kDecayStart);
  EXPECT_EQ(result.evaluations, 1);
}

TEST(Refine, StopsAfterTheIterationWhereItIsAsked) {
  double last_cost = Decay(kDecayStart).cost();
  for (int iterations = 0; iterations < 5; ++iterations) {
    Archive archive({DecayLattice(), Decay});
    int asked = 0;
    const RefineResult result = Refine(archive, kDecayStart, {}, [&] { return asked++ == iterations; });
    EXPECT_EQ(result.end, RefineEnd::kStopped);
    EXPECT_EQ(result.iterations, iterations);
    EXPECT_LE(result.cost, last_cost);
    EXPECT_EQ(result.jacobian.rows(), 20);
    last_cost = result.cost;
  }
  EXPECT_LT(last_cost, Decay(kDecayStart).cost());
}

TEST(Refine, EndsAfterItsIterations) {
  Archive archive({DecayLattice(), Decay});
  RefineOptions options;
  options.max_iterations = 0;
  const RefineResult none = Refine(archive, kDecayStart, options);
  EXPECT_EQ(none.end, RefineEnd::kIterations);
  EXPECT_EQ(none.cost, none.start_cost);
  EXPECT_EQ(none.jacobian.rows(), 20);
  options.max_iterations = 3;
  const RefineResult three = Refine(archive, kDecayStart, options);
  EXPECT_EQ(three.end, RefineEnd::kIterations);
  EXPECT_EQ(three.iterations, 3);
  EXPECT_LT(three.cost, none.cost);
}

TEST(Refine, GivesTheSameForAnyNumberOfThreads) {
  Archive alone(StationProblem(1), 1);
  const RefineResult reference = Refine(alone, StationLattice().Values({1000, 100, 1000, 10000, 1000}));
  for (const int threads : {2, 4}) {
    Archive archive(StationProblem(1), threads);
    const RefineResult result = Refine(archive, StationLattice().Values({1000, 100, 1000, 10000, 1000}));
    EXPECT_EQ(result.values, reference.values);
    EXPECT_EQ(result.cost, reference.cost);
    EXPECT_EQ(result.jacobian, reference.jacobian);
    EXPECT_EQ(result.evaluations, reference.evaluations);
  }
}

TEST(Refine, RefusesAStartOutOfBoundsByName) {
  Archive archive({DecayLattice(), Decay});
  EXPECT_THAT([&] { Refine(archive, Eigen::Vector2d(11, 1)); },
              ThrowsMessage<std::invalid_argument>(StrEq("a = 11, must be in [0.1, 10]")));
  EXPECT_EQ(archive.counts().paid, 0);
}

TEST(Refine, RefusesOptionsOutOfBoundsByName) {
  const auto message = [](auto spoil) {
    RefineOptions options;
    spoil(options);
    try {
      options.Validate();
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message([](RefineOptions&) {}), "");
  EXPECT_EQ(message([](RefineOptions& o) { o.max_iterations = -1; }), "max_iterations = -1, must be 0 or more");
  EXPECT_EQ(message([](RefineOptions& o) { o.step = 0.2; }), "step = 0.2, must be in [0, 0.1]");
  EXPECT_EQ(message([](RefineOptions& o) { o.step = std::nan(""); }), "step = nan, must be in [0, 0.1]");
  EXPECT_EQ(message([](RefineOptions& o) { o.cost_tolerance = 0; }), "cost_tolerance = 0, must be in (0, 1)");
  EXPECT_EQ(message([](RefineOptions& o) { o.step_tolerance = 1; }), "step_tolerance = 1, must be in (0, 1)");
  EXPECT_EQ(message([](RefineOptions& o) { o.nearness = 1; }), "nearness = 1, must be in [0, 1)");
  EXPECT_EQ(message([](RefineOptions& o) { o.agreement = -1; }), "agreement = -1, must be in (0, 1)");
}

TEST(Refine, EndsWhereTheOptimumIsNearEnough) {
  std::int64_t paid = 0;
  std::int64_t paid_near = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Archive archive(StationProblem(seed));
    const Eigen::VectorXd start = RandomStarts(archive.lattice(), 1).front();
    const RefineResult optimum = Refine(archive, start);
    const RefineResult near = Refine(archive, start, {.nearness = 0.1});
    EXPECT_EQ(near.end, RefineEnd::kConverged);
    const Eigen::VectorXd slopes = FitVariables(archive.lattice()).Slopes(optimum.values);
    const Covariance covariance = EstimateCovariance(optimum.jacobian, slopes, optimum.cost);
    // With a tenth for what is not linear, and for the sd of 115 degrees of freedom.
    EXPECT_LT(((near.values - optimum.values).array() / covariance.sd.array()).abs().maxCoeff(), 0.11) << seed;
    paid += optimum.evaluations;
    paid_near += near.evaluations;
  }
  EXPECT_LT(paid_near, paid);
}

TEST(Refine, GoesOnWhereAllThatIsLeftCanBeExplained) {
  Archive archive(StationProblem());
  const Eigen::VectorXd start = RandomStarts(archive.lattice(), 1).front();
  const RefineResult result = Refine(archive, start, {.nearness = 0.1});
  // As without it: step_tolerance times the norm of the variables, 20.
  EXPECT_LT(LargestRelativeError(result.values, kStationTruth), 20 * 1e-8);
}

TEST(Refine, EndsHaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const RefineEnd end :
       {RefineEnd::kNotRun, RefineEnd::kConverged, RefineEnd::kIterations, RefineEnd::kStartFailed, RefineEnd::kFailed,
        RefineEnd::kStopped, RefineEnd::kGivenUp, RefineEnd::kKnown}) {
    names.insert(RefineEndName(end));
  }
  EXPECT_EQ(names.size(), 8u);
  EXPECT_FALSE(names.contains("unknown"));
}

// Twin experiment: a short search, refinement of its best points, covariance.
struct Twin {
  RefineResult best;
  int agreeing = 0;
  Covariance covariance;
};

Twin SearchAndRefine(std::uint64_t noise_seed) {
  Archive archive(StationProblem(noise_seed));
  DvhdeSearch options;
  options.max_evaluations = 200;
  options.candidates = 3;
  std::vector<Eigen::VectorXd> starts;
  for (const Candidate& candidate : SearchDvhde(archive, options).candidates) starts.push_back(candidate.values);
  const MultiStartResult refined = RefineFrom(archive, starts);
  Twin twin;
  twin.best = refined.runs.at(static_cast<std::size_t>(refined.best));
  twin.agreeing = refined.agreeing;
  const FitVariables variables(archive.lattice());
  twin.covariance = EstimateCovariance(twin.best.jacobian, variables.Slopes(twin.best.values), twin.best.cost);
  return twin;
}

TEST(TwinExperiment, RecoversTheParametersFromExactResponses) {
  const Twin twin = SearchAndRefine(0);
  EXPECT_EQ(twin.agreeing, 3);
  EXPECT_EQ(twin.covariance.rank, 5);
  // step_tolerance times the norm of the variables, 20.
  EXPECT_LT(LargestRelativeError(twin.best.values, kStationTruth), 20 * 1e-8);
}

// 40 data sets of 5 parameters.
TEST(TwinExperiment, RecoversTheParametersFromNoisyResponsesWithinTheirUncertainty) {
  const int sets = 40;
  double squares = 0;
  for (int seed = 1; seed <= sets; ++seed) {
    const Twin twin = SearchAndRefine(static_cast<std::uint64_t>(seed));
    EXPECT_EQ(twin.agreeing, 3);
    const Eigen::ArrayXd error = (twin.best.values - kStationTruth).array() / twin.covariance.sd.array();
    // One in 80 of such tests exceeds 4 standard deviations; the seeds are fixed.
    EXPECT_LT(error.abs().maxCoeff(), 4);
    squares += error.square().sum() / (5 * sets);
    // 120 residuals of variance 1 less 5 parameters; 4 standard deviations of chi-square.
    EXPECT_NEAR(twin.best.cost, 115, 4 * std::sqrt(2 * 115));
  }
  // Neither too small nor too large: 4 standard deviations of the mean of 200 squares.
  EXPECT_NEAR(squares, 1, 4 * std::sqrt(2.0 / (5 * sets)));
}

}  // namespace
}  // namespace fourpost::refine_test
