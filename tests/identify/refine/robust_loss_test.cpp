#include "identify/refine/robust_loss.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include <gmock/gmock.h>

#include "identify/refine/refine.h"

namespace fourpost::robust_loss_test {
namespace {

constexpr std::array<LossKind, 4> kLosses = {LossKind::kHuber, LossKind::kSoftL1, LossKind::kCauchy, LossKind::kTukey};

/// rho(r^2) as the header writes it.
double Written(LossKind kind, double scale, double r) {
  const double s = r * r / (scale * scale);
  const double of_s = [&] {
    switch (kind) {
      case LossKind::kNone: return s;
      case LossKind::kHuber: return s <= 1 ? s : 2 * std::sqrt(s) - 1;
      case LossKind::kSoftL1: return 2 * (std::sqrt(1 + s) - 1);
      case LossKind::kCauchy: return std::log1p(s);
      case LossKind::kTukey: return s <= 1 ? (1 - std::pow(1 - s, 3)) / 3 : 1.0 / 3;
    }
    return 0.0;
  }();
  return scale * scale * of_s;
}

Eigen::VectorXd One(double r) { return Eigen::VectorXd::Constant(1, r); }

TEST(RobustLoss, IsWhatItsFormulaSays) {
  for (const LossKind kind : kLosses)
    for (const double scale : {0.5, 1.0, 3.0})
      for (const double r : {0.0, 0.2, -0.7, 1.3, -8.0, 1e3}) {
        const RobustLoss loss(kind, scale, 0);
        const double written = Written(kind, scale, r);
        // Rounding; that of 1 + s for small s.
        EXPECT_NEAR(loss.Cost(One(r)), written, 1e-14 * (written + scale * scale)) << loss.name() << ' ' << r;
        EXPECT_NEAR(std::pow(loss.Transformed(One(r))[0], 2), written, 1e-14 * (written + scale * scale));
        EXPECT_EQ(std::signbit(loss.Transformed(One(r))[0]), std::signbit(r));
      }
}

TEST(RobustLoss, SquaresSmallResidualsAndPriorsAndAllWithoutALoss) {
  const Eigen::VectorXd residuals = Eigen::Vector3d(1e-4, -20, 30);
  EXPECT_EQ(RobustLoss().Cost(residuals), residuals.squaredNorm());
  EXPECT_EQ(RobustLoss().Transformed(residuals), residuals);
  EXPECT_EQ(RobustLoss().Slopes(residuals), Eigen::Vector3d::Ones());
  for (const LossKind kind : kLosses) {
    const RobustLoss loss(kind, 1, 2);
    EXPECT_NEAR(loss.Transformed(residuals)[0], 1e-4, 1e-4 * 1e-7);  // the next term is of the order of s
    EXPECT_EQ(loss.Transformed(residuals).tail(2), residuals.tail(2));
    EXPECT_EQ(loss.Slopes(residuals).tail(2), Eigen::Vector2d::Ones());
    EXPECT_LT(RobustLoss(kind, 1, 1).Cost(residuals), loss.Cost(residuals) - 100) << loss.name();
  }
}

TEST(RobustLoss, HasTheSlopesOfItsTransformation) {
  constexpr double kStep = 1e-6;
  for (const LossKind kind : kLosses)
    for (const double r : {-5.0, -0.9, 0.3, 1.1, 2.0}) {
      const RobustLoss loss(kind, 1, 0);
      const double difference =
          (loss.Transformed(One(r + kStep))[0] - loss.Transformed(One(r - kStep))[0]) / (2 * kStep);
      // Of central differences: step squared, and rounding over step.
      EXPECT_NEAR(loss.Slopes(One(r))[0], difference, 1e-9) << loss.name() << ' ' << r;
    }
  for (const LossKind kind : kLosses) EXPECT_EQ(RobustLoss(kind, 1, 0).Slopes(One(0))[0], 1);
}

TEST(RobustLoss, HasTheWeightsAndCurvaturesOfItsGradient) {
  constexpr double kStep = 1e-6;
  for (const LossKind kind : kLosses)
    for (const double r : {-5.0, -0.9, 0.3, 1.1, 2.0}) {
      const RobustLoss loss(kind, 1, 0);
      const auto half_slope = [&](double at) {
        return (loss.Cost(One(at + kStep)) - loss.Cost(One(at - kStep))) / (4 * kStep);
      };
      // Of central differences: rounding of the cost over the step, and over the step once more.
      EXPECT_NEAR(r * loss.Weights(One(r))[0], half_slope(r), 1e-8) << loss.name() << ' ' << r;
      const auto psi = [&](double at) { return at * loss.Weights(One(at))[0]; };
      EXPECT_NEAR(loss.Curvatures(One(r))[0], (psi(r + kStep) - psi(r - kStep)) / (2 * kStep), 1e-8) << loss.name();
    }
}

// That is how the usual scales are chosen.
TEST(RobustLoss, LosesFivePercentOfPrecisionToNormalNoiseAtItsUsualScale) {
  constexpr int kCount = 20001;
  constexpr double kFar = 8;
  for (const LossKind kind : kLosses) {
    // Residuals as dense as a normal density: equal shares of probability by its quantiles would do; here weights.
    double squares = 0;
    double slope = 0;
    const RobustLoss loss(kind, UsualScale(kind), 0);
    for (int i = 0; i < kCount; ++i) {
      const double r = -kFar + 2 * kFar * i / (kCount - 1);
      const double weight = std::exp(-r * r / 2) / std::sqrt(2 * std::numbers::pi) * 2 * kFar / (kCount - 1);
      const double h = 1e-5;
      const auto psi = [&](double at) { return loss.Transformed(One(at))[0] * loss.Slopes(One(at))[0]; };
      squares += weight * psi(r) * psi(r);
      slope += weight * (psi(r + h) - psi(r - h)) / (2 * h);
    }
    // Printed digits of the scales.
    EXPECT_NEAR(slope * slope / squares, 0.95, 5e-4) << loss.name();
  }
}

TEST(RobustLoss, EquivalentCostIsThatOfTheNoiseWhateverTheLoss) {
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  Eigen::VectorXd residuals(20000);
  for (double& r : residuals) r = normal(engine);
  EXPECT_EQ(RobustLoss().EquivalentCost(residuals), residuals.squaredNorm());
  for (const LossKind kind : kLosses) {
    const RobustLoss loss(kind, UsualScale(kind), 0);
    // 95 % efficiency; four standard deviations of a variance of 20000.
    EXPECT_NEAR(loss.EquivalentCost(residuals) / 20000, 1 / 0.95, 4 * std::sqrt(2.0 / 20000)) << loss.name();
    Eigen::VectorXd soiled = residuals;
    soiled.head(400).setConstant(50);
    EXPECT_LT(loss.EquivalentCost(soiled) / 20000, 1.3) << loss.name();
    EXPECT_GT(soiled.squaredNorm() / 20000, 50);
  }
}

TEST(RobustLoss, ResidualsThatAreAllRejectedDetermineNothing) {
  const RobustLoss tukey(LossKind::kTukey, 1, 0);
  EXPECT_EQ(tukey.EquivalentCost(Eigen::Vector3d(5, -7, 9)), std::numeric_limits<double>::infinity());
  // Where Tukey's psi falls, at the scale over sqrt(5) and beyond.
  EXPECT_EQ(tukey.EquivalentCost(Eigen::Vector2d(0.5, -0.6)), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isfinite(tukey.EquivalentCost(Eigen::Vector2d(0.4, -7))));
}

TEST(RobustLoss, RefusesAScaleThatIsNone) {
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THROW(RobustLoss(LossKind::kHuber, bad, 0), std::invalid_argument);
}

/// y = p0 + p1 t in 100 points with noise of deviation 1, ten of them 40 off.
Problem SoiledLine() {
  std::mt19937 engine(5);
  std::normal_distribution<double> normal;
  Eigen::VectorXd y(100);
  for (Eigen::Index i = 0; i < 100; ++i) y[i] = 30 + 0.5 * static_cast<double>(i) + normal(engine);
  for (Eigen::Index i = 85; i < 95; ++i) y[i] += 40;
  return {Lattice({{"offset", -100, 100, 0.1}, {"slope", -10, 10, 0.01}}), [y](const Eigen::VectorXd& p) {
            Evaluation evaluation;
            evaluation.residuals = Eigen::VectorXd::LinSpaced(100, 0, 99) * p[1] - y;
            evaluation.residuals.array() += p[0];
            return evaluation;
          }};
}

RefineResult Line(const RobustLoss& loss) {
  Archive archive(SoiledLine());
  RefineOptions options;
  options.loss = loss;
  return Refine(archive, Eigen::Vector2d(0, 0), options);
}

TEST(RobustLoss, KeepsOutliersFromPullingALine) {
  // Standard deviation of the slope without outliers: 1 / sqrt(sum (t - mean)^2).
  const double sd = 1 / std::sqrt(100.0 * (100 * 100 - 1) / 12);
  EXPECT_GT(std::abs(Line({}).values[1] - 0.5), 20 * sd);
  for (const LossKind kind : kLosses) {
    const RobustLoss loss(kind, UsualScale(kind), 0);
    const RefineResult line = Line(loss);
    EXPECT_EQ(line.end, RefineEnd::kConverged) << loss.name() << line.message;
    // Huber's and soft_l1's outliers pull with a bounded force each: ten of them by some deviations.
    const double most = kind == LossKind::kHuber || kind == LossKind::kSoftL1 ? 8 : 4;
    EXPECT_NEAR(line.values[1], 0.5, most * sd) << loss.name();
    EXPECT_NEAR(line.cost, loss.Cost(line.residuals), 1e-12 * line.cost);
    EXPECT_EQ(line.start_cost, loss.Cost(SoiledLine().evaluate(Eigen::Vector2d(0, 0)).residuals)) << loss.name();
    // The residuals are those of the model, and so is the Jacobian: by the offset, a share of its range of 200.
    EXPECT_NEAR(line.residuals.cwiseAbs().maxCoeff(), 40, 6) << loss.name();
    EXPECT_NEAR(line.jacobian(3, 0), 200, 1e-4) << loss.name();
  }
}

/// One residual 100 (x - 1) and ten of 5 sin(3 x): by squares a valley of ripples, its bottom next to pi / 3; by
/// Huber's loss each zero of the sine is an optimum of its own, for the ten pull with up to 400, the one with 270.
Problem RippledValley() {
  return {Lattice({{"x", -10, 10, 0.001}}), [](const Eigen::VectorXd& p) {
            Evaluation evaluation;
            evaluation.residuals = Eigen::VectorXd::Constant(11, 5 * std::sin(3 * p[0]));
            evaluation.residuals[0] = 100 * (p[0] - 1);
            return evaluation;
          }};
}

RefineResult InTheValley(double start) {
  Archive archive(RippledValley());
  RefineOptions options;
  options.loss = RobustLoss(LossKind::kHuber, UsualScale(LossKind::kHuber), 0);
  return Refine(archive, Eigen::VectorXd::Constant(1, start), options);
}

TEST(RobustLoss, IsLedBySquaresFromAfar) {
  const RefineResult result = InTheValley(4.4);
  EXPECT_EQ(result.end, RefineEnd::kConverged) << result.message;
  // Between the one residual's zero and the sine's.
  EXPECT_GE(result.values[0], 1);
  EXPECT_LE(result.values[0], std::numbers::pi / 3);
}

TEST(RobustLoss, IsNotLedAwayFromItsOptimum) {
  const double optimum = InTheValley(4.4).values[0];
  const RefineResult again = InTheValley(optimum);
  EXPECT_NEAR(again.values[0], optimum, 1e-6);
  EXPECT_LE(again.iterations, 2);
  // That of another ripple stays one, too, for most residuals are small there: where 10 d(5 sin 3x)^2/dx is as strong
  // as the one residual's 200 scale.
  const double scale = UsualScale(LossKind::kHuber);
  const double other = 4 * std::numbers::pi / 3 - std::asin(200 * scale / 750) / 6;
  EXPECT_NEAR(InTheValley(other).values[0], other, 1e-6);
}

}  // namespace
}  // namespace fourpost::robust_loss_test
