#include "identify/uncertainty/posterior_draws.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "identify/uncertainty/truncated_normal.h"

namespace fourpost::posterior_draws_test {
namespace {

using Points = std::vector<Eigen::VectorXd>;

Eigen::VectorXd One(double x) { return Eigen::VectorXd::Constant(1, x); }
Eigen::MatrixXd Square(double x) { return Eigen::MatrixXd::Constant(1, 1, x); }

double Mean(const Points& points, Eigen::Index j = 0) {
  double sum = 0;
  for (const Eigen::VectorXd& point : points) sum += point[j];
  return sum / static_cast<double>(points.size());
}

double Covariance(const Points& points, Eigen::Index i, Eigen::Index j) {
  double sum = 0;
  for (const Eigen::VectorXd& point : points) sum += (point[i] - Mean(points, i)) * (point[j] - Mean(points, j));
  return sum / static_cast<double>(points.size());
}

double ShareAbove(const Points& points, double limit) {
  const auto above = std::count_if(points.begin(), points.end(), [&](const auto& point) { return point[0] > limit; });
  return static_cast<double>(above) / static_cast<double>(points.size());
}

/// One variable with this cost and its curvature at zero, where the optimum is; covariance 1.
Posterior OfOne(double hessian, double lower, double upper) {
  return {
      {{.centre = One(0), .cost = 0, .hessian = Square(hessian), .slope = One(0)}}, Square(1), One(lower), One(upper)};
}

CostsOf Costs(double (*cost)(double)) {
  return [cost](const Points& points) {
    std::vector<double> costs;
    for (const Eigen::VectorXd& point : points) costs.push_back(cost(point[0]));
    return costs;
  };
}

// Means of a normal number beyond a, of density phi: phi(a) / (1 - Phi(a)).
TEST(TruncatedNormal, HasTheMeanOfItsPart) {
  const auto phi = [](double x) { return std::exp(-x * x / 2) / std::sqrt(2 * M_PI); };
  const auto above = [](double x) { return std::erfc(x / std::sqrt(2.0)) / 2; };
  for (const auto& [lower, upper] :
       {std::pair{-1.0, 0.5}, {0.3, 9.0}, {4.0, 30.0}, {6.0, 6.05}, {-2.0, -1.5}, {-0.1, 7.0}}) {
    const double mean = (phi(lower) - phi(upper)) / (above(lower) - above(upper));
    double sum = 0;
    constexpr int kCount = 20000;
    Draws draws(3, DrawPurpose::kPosterior, 0, 0);
    for (int i = 0; i < kCount; ++i) {
      const double x = DrawNormalBetween(lower, upper, draws);
      ASSERT_GE(x, lower);
      ASSERT_LE(x, upper);
      sum += x;
    }
    EXPECT_NEAR(sum / kCount, mean, 4 * std::min(1.0, upper - lower) / std::sqrt(kCount)) << lower << " " << upper;
  }
}

TEST(PosteriorDraws, OfANormalHaveItsCovarianceWithinWideBounds) {
  Eigen::Matrix2d covariance;
  covariance << 4, 1.8, 1.8, 1;
  const Posterior posterior({{.centre = Eigen::Vector2d(1, 2), .cost = 0, .hessian = {}, .slope = {}}}, covariance,
                            Eigen::Vector2d(-50, -50), Eigen::Vector2d(50, 50));
  const Points points = DrawNormals(posterior, {.count = 4000}).points;
  EXPECT_NEAR(Mean(points, 0), 1, 0.13);
  EXPECT_NEAR(Mean(points, 1), 2, 0.07);
  EXPECT_NEAR(Covariance(points, 0, 0), 4, 0.4);
  EXPECT_NEAR(Covariance(points, 0, 1), 1.8, 0.18);
  EXPECT_NEAR(Covariance(points, 1, 1), 1, 0.1);
}

// Half a normal distribution: mean sqrt(2 / pi), and no draw on the bound.
TEST(PosteriorDraws, DoNotPileUpAtABound) {
  const Points points = DrawNormals(OfOne(1, 0, 50), {.count = 4000}).points;
  for (const Eigen::VectorXd& point : points) ASSERT_GT(point[0], 0);
  EXPECT_NEAR(Mean(points), std::sqrt(2 / M_PI), 0.04);
}

// A corner of five correlated variables: every draw within, whose share of plain draws is a thousandth.
// Of a uniform number and a normal one mean and variance add up: m / 2, and 1 + m^2 / 12.
TEST(PosteriorDraws, LieBetweenAnOptimumAndWhereItWouldMove) {
  const Points points = DrawNormals(OfOne(1, -50, 50), {.count = 4000, .moved = One(-6)}).points;
  EXPECT_NEAR(Mean(points), -3, 4 * 2 / std::sqrt(4000.0));
  EXPECT_NEAR(Covariance(points, 0, 0), 4, 0.4);
  // Upper tail Q from 1 to 7 on average: (phi(1) - Q(1)) / 6; chance of 4000 draws.
  EXPECT_NEAR(ShareAbove(points, 1), 0.0139, 0.0075);
}

// The mean of normal numbers above -2 about centres from -2 to 0, by 400000 draws of scipy's truncnorm.
TEST(PosteriorDraws, MoveAsFarAsBoundsAllow) {
  const Points points = DrawNormals(OfOne(1, -2, 50), {.count = 4000, .moved = One(-1000)}).points;
  for (const Eigen::VectorXd& point : points) ASSERT_GE(point[0], -2);
  EXPECT_NEAR(Mean(points), -0.665, 0.055);
}

TEST(PosteriorDraws, FillACorner) {
  constexpr Eigen::Index kSize = 5;
  const Eigen::MatrixXd covariance =
      0.5 * Eigen::MatrixXd::Identity(kSize, kSize) + Eigen::MatrixXd::Constant(kSize, kSize, 0.5);
  const Posterior posterior({{.centre = Eigen::VectorXd::Zero(kSize), .cost = 0, .hessian = {}, .slope = {}}},
                            covariance, Eigen::VectorXd::Zero(kSize), Eigen::VectorXd::Constant(kSize, 50));
  Points plain;
  for (std::size_t i = 0; i < 60000; ++i) {
    Draws draws(9, DrawPurpose::kInitial, 0, i);
    Eigen::VectorXd x(kSize);
    const double common = draws.Normal();
    for (double& component : x) component = std::sqrt(0.5) * (common + draws.Normal());
    if ((x.array() > 0).all()) plain.push_back(x);
  }
  const Points points = DrawNormals(posterior, {.count = 4000}).points;
  for (const Eigen::VectorXd& point : points) ASSERT_GT(point.minCoeff(), 0);
  EXPECT_NEAR(Mean(points, 2), Mean(plain, 2), 0.05);
  EXPECT_NEAR(Covariance(points, 0, 1), Covariance(plain, 0, 1), 0.05);
}

// Cost 9 x^2 of variance 1/9, but the covariance is 1: noise is three times what the cost says.
TEST(PosteriorDraws, OfAParabolaHaveTheCovarianceThatIsKnown) {
  const PosteriorDraws draws =
      DrawByCost(OfOne(9, -50, 50), Costs([](double x) { return 9 * x * x; }), {.count = 2000});
  EXPECT_EQ(draws.method, DrawMethod::kWeighted);
  EXPECT_NEAR(draws.effective, 2000, 1e-6);
  EXPECT_NEAR(Covariance(draws.points, 0, 0), 1, 0.1);
}

// exp(-x) of x > 0 beyond its optimum's side: cost 2 |x| below, x^2 above. Shares by integrals: 1 and sqrt(pi / 2).
TEST(PosteriorDraws, FollowACostThatIsNoParabola) {
  const PosteriorDraws draws =
      DrawByCost(OfOne(1, -50, 50), Costs([](double x) { return x < 0 ? -2 * x : x * x; }), {.count = 4000});
  EXPECT_EQ(draws.method, DrawMethod::kWeighted);
  EXPECT_LT(draws.effective, 3950);
  const double above = std::sqrt(M_PI / 2);
  EXPECT_NEAR(ShareAbove(draws.points, 0), above / (1 + above), 0.03);
}

// The optimum claims a curvature eighty times too large: normal draws are far too narrow.
TEST(PosteriorDraws, MoveWhereNormalOnesAreTooNarrow) {
  const Posterior posterior({{.centre = One(0), .cost = 0, .hessian = Square(1), .slope = One(0)}}, Square(1),
                            One(-500), One(500));
  // Density 1 / (1 + x^2 / 400)^(5 / 2).
  const auto cost = Costs([](double x) { return 5 * std::log1p(x * x / 400); });
  const PosteriorDraws draws = DrawByCost(posterior, cost, {.count = 1000, .max_evaluations = 400000});
  ASSERT_EQ(draws.method, DrawMethod::kEnsemble);
  EXPECT_LT(draws.remembered, 0.3);
  // Student's t of 4 degrees, scale 10: a quarter is above 7.407, and a twentieth above 21.32.
  EXPECT_NEAR(ShareAbove(draws.points, 7.407), 0.25, 0.06);
  EXPECT_NEAR(ShareAbove(draws.points, 0), 0.5, 0.06);
}

// Two wells, the second half as wide and deeper by 2: evidence exp(1) / 2 to 1.
double TwoWells(double x) { return x < 5 ? x * x : 4 * (x - 10) * (x - 10) - 2; }

TEST(PosteriorDraws, EnterOptimaInProportionToTheirEvidence) {
  const std::vector<PosteriorOptimum> optima = {{.centre = One(10), .cost = -2, .hessian = Square(4), .slope = One(0)},
                                                {.centre = One(0), .cost = 0, .hessian = Square(1), .slope = One(0)}};
  const Posterior posterior(optima, Square(0.25), One(-50), One(50));
  const double expected = std::exp(1.0) / 2 / (std::exp(1.0) / 2 + 1);
  EXPECT_NEAR(posterior.shares()[0], expected, 1e-9);
  const PosteriorDraws normal = DrawNormals(posterior, {.count = 2000});
  EXPECT_NEAR(ShareAbove(normal.points, 5), expected, 0.002);
  const PosteriorDraws weighted = DrawByCost(posterior, Costs(TwoWells), {.count = 2000});
  EXPECT_EQ(weighted.method, DrawMethod::kWeighted);
  EXPECT_GT(weighted.effective, 1990);
  EXPECT_NEAR(ShareAbove(weighted.points, 5), expected, 0.01);
}

// With twice the covariance, of noise twice as large as stated, costs count half.
TEST(PosteriorDraws, WeighOptimaByTheNoiseThatIsKnown) {
  const std::vector<PosteriorOptimum> optima = {{.centre = One(10), .cost = -2, .hessian = Square(4), .slope = One(0)},
                                                {.centre = One(0), .cost = 0, .hessian = Square(1), .slope = One(0)}};
  const Posterior posterior(optima, Square(0.5), One(-50), One(50));
  EXPECT_NEAR(posterior.shares()[0], std::exp(0.5) / 2 / (std::exp(0.5) / 2 + 1), 1e-9);
}

// Half of the second well is out of bounds.
TEST(PosteriorDraws, CountEvidenceWithinBoundsOnly) {
  const std::vector<PosteriorOptimum> optima = {{.centre = One(10), .cost = 0, .hessian = Square(1), .slope = One(0)},
                                                {.centre = One(0), .cost = 0, .hessian = Square(1), .slope = One(0)}};
  const Posterior posterior(optima, Square(1), One(0), One(50));
  EXPECT_NEAR(posterior.shares()[0], 2.0 / 3, 0.02);
}

TEST(PosteriorDraws, LeaveOutWhatCannotBeEvaluated) {
  const PosteriorDraws draws =
      DrawByCost(OfOne(1, -50, 50), Costs([](double x) { return x > 0.5 ? std::nan("") : x * x; }), {.count = 500});
  for (const Eigen::VectorXd& point : draws.points) EXPECT_LE(point[0], 0.5);
}

}  // namespace
}  // namespace fourpost::posterior_draws_test
