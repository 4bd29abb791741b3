#pragma once

#include <functional>
#include <optional>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "identify/refine/robust_loss.h"
#include "identify/residuals/residual_structure.h"

namespace fourpost {

/// A fitted point, about which additions are judged. N residuals, n variables.
struct FittedPoint {
  /// Priors included.
  Eigen::VectorXd residuals;
  /// d residuals / d FitVariables; zero columns of those at their bounds.
  Eigen::MatrixXd jacobian;
  RobustLoss loss;
};

/// What is left of a cost when the n variables follow, to first order.
struct Followed {
  double cost = 0;
  /// Of FitVariables.
  Eigen::VectorXd step;
  /// Residuals with the step.
  Eigen::VectorXd left;
};

/// Residuals that changed, with the variables following: min over d of the loss of r + J d, by iteratively reweighted
/// least squares.
class FollowedCost {
 public:
  explicit FollowedCost(FittedPoint point);

  Followed Of(const Eigen::VectorXd& residuals) const;
  /// Residuals that no step accounts for, with the weights of the fitted point: linear in `residuals`.
  Eigen::VectorXd Remainder(const Eigen::VectorXd& residuals) const;
  /// Residuals times the square roots of the fitted point's weights.
  Eigen::VectorXd Weighted(const Eigen::VectorXd& residuals) const;
  /// Half the derivative of the cost by each variable.
  Eigen::VectorXd Slope() const;
  const FittedPoint& point() const { return point_; }

 private:
  Eigen::LDLT<Eigen::MatrixXd> Normal(const Eigen::VectorXd& weights) const;

  FittedPoint point_;
  Eigen::VectorXd weights_;
  Eigen::LDLT<Eigen::MatrixXd> normal_;
};

/// The residuals for an amount of something new and a step of the variables; nothing where they cannot be evaluated.
using ResidualsOf = std::function<std::optional<Eigen::VectorXd>(double amount, const Eigen::VectorXd& step)>;

/// What an addition is worth.
struct ScoreTest {
  double amount = 0;
  /// Below that of the fitted point.
  double cost = 0;
  Eigen::VectorXd step;
  /// Residuals with the amount that TestAmount() found, variables as they were.
  Eigen::VectorXd alone;
  /// With it, variables following.
  Eigen::VectorXd left;
  /// By Confirm(): the cost is that of an evaluation, below that without it.
  bool is_confirmed = false;
  int evaluations = 0;
};

struct AmountRange {
  double first = 1;
  double least = 0;
  double greatest = 0;
};

/// Half of the least fall of a cost with which CriterionChange() could be below 0, however independent residuals are:
/// what promises less, with one amount known, is not looked at further.
double LeastPromise(double cost, Eigen::Index residuals, std::size_t additions);

/// The amount at which the cost, variables following, is least: residuals are linear in the amount between 0 and those
/// that were evaluated, of which there are four at most; the best of these is the answer. A score test takes the first
/// of them to be small (Rao 1948); laws with kinks, which begin to act at some amount, need the others. Nothing where
/// none can be evaluated. It ends with what is known where no amount promises a fall of `least_promise`.
std::optional<ScoreTest> TestAmount(const FollowedCost& fitted, const AmountRange& range, const ResidualsOf& residuals,
                                    double least_promise = 0);

/// The same by residuals at the first amount alone, not evaluated but known to first order.
ScoreTest TestToFirstOrder(const FollowedCost& fitted, const AmountRange& range, const Eigen::VectorXd& at_first);

/// Goes on from there: steps of the amount and the variables together with the derivatives that are known, each
/// evaluated truly and kept where the cost falls. Where it never does, the test says that nothing is left or moved.
void Confirm(const FollowedCost& fitted, const AmountRange& range, const ResidualsOf& residuals, ScoreTest& test);

/// How many independent residuals would say as much: of each series n (1 - c) / (1 + c), c: correlation of neighbours,
/// not below 0. Where a model is too simple its residuals are alike over frequency and time.
double EffectiveResiduals(const Eigen::VectorXd& residuals, const ResidualStructure& structure);

/// Change of the extended Bayesian criterion (Chen and Chen, Biometrika 95, 2008), below 0 where it is worth adding:
///   n ln(cost / cost before) + k ln n + 2 choices ln(additions).
/// The misfit takes the place of the noise, so that errors of a model that is too simple count as noise does. The last
/// term allows for the best of many models: an addition is one of so many, however many numbers it brings, and one that
/// makes two changes, each of which could be made alone, one of as many squared. Where the cost is below the number of
/// residuals, what is missing is added to both costs: stated noise and model error explain the data, and no pattern
/// within them asks for more.
double CriterionChange(double cost_before, double cost, Eigen::Index residuals, double effective, int parameters,
                       std::size_t additions, int choices = 1);

}  // namespace fourpost
