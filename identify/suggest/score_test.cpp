#include "identify/suggest/score_test.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/QR>

namespace fourpost {
namespace {

using Eigen::Index;

struct Tried {
  double amount = 0;
  Eigen::VectorXd residuals;
  Followed followed;
};

/// Residuals at an amount, linear between those that are known and on from the outermost. `tried`: by amount, 0 among
/// them.
Eigen::VectorXd Interpolated(const std::vector<Tried>& tried, double amount) {
  std::size_t after = 1;
  while (after + 1 < tried.size() && tried[after].amount < amount) ++after;
  const Tried& a = tried[after - 1];
  const Tried& b = tried[after];
  return a.residuals + (amount - a.amount) / (b.amount - a.amount) * (b.residuals - a.residuals);
}

/// Of the interpolated residuals, on a grid that is refined once.
double BestAmount(const FollowedCost& fitted, const AmountRange& range, const std::vector<Tried>& tried) {
  constexpr double kFurther = 6;
  constexpr int kPoints = 24;
  double reach = 0;
  for (const Tried& one : tried) reach = std::max(reach, std::abs(one.amount));
  double from = std::max(range.least, -kFurther * reach);
  double to = std::min(range.greatest, kFurther * reach);
  double best = tried.back().amount;
  for (int round = 0; round < 2; ++round) {
    const double step = (to - from) / kPoints;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kPoints; ++i) {
      const double amount = from + i * step;
      const double cost = fitted.Of(Interpolated(tried, amount)).cost;
      if (cost < least) {
        least = cost;
        best = amount;
      }
    }
    from = std::max(range.least, best - step);
    to = std::min(range.greatest, best + step);
  }
  return best;
}

}  // namespace

FollowedCost::FollowedCost(FittedPoint point) : point_(std::move(point)) {}

Followed FollowedCost::Of(const Eigen::VectorXd& residuals) const {
  constexpr int kRounds = 3;
  // A variable may move by its range, or by a factor e: weak, and enough where nothing else determines it.
  constexpr double kLoose = 1e-3;
  Followed followed;
  const Eigen::MatrixXd& jacobian = point_.jacobian;
  const Index n = jacobian.cols();
  followed.step = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd now = residuals;
  const int rounds = point_.loss.kind() == LossKind::kNone ? 1 : kRounds;
  Eigen::VectorXd weights;
  for (int round = 0; round < rounds; ++round) {
    weights = point_.loss.Weights(now);
    Eigen::MatrixXd normal = jacobian.transpose() * weights.asDiagonal() * jacobian;
    const double scale = normal.diagonal().size() > 0 ? normal.diagonal().maxCoeff() : 1;
    normal.diagonal().array() += kLoose * std::min(1.0, scale) + 1e-12 * scale;
    const Eigen::VectorXd pull = jacobian.transpose() * weights.cwiseProduct(residuals);
    followed.step = -normal.ldlt().solve(pull);
    now = residuals + jacobian * followed.step;
  }
  followed.cost = point_.loss.Cost(now);
  followed.left = weights.cwiseSqrt().cwiseProduct(now);
  return followed;
}

std::optional<ScoreTest> TestAmount(const FollowedCost& fitted, const AmountRange& range,
                                    const ResidualsOf& residuals) {
  constexpr int kMost = 4;
  constexpr double kSame = 0.15;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(fitted.point().jacobian.cols());
  const Followed before = fitted.Of(fitted.point().residuals);
  std::vector<Tried> tried = {{0, fitted.point().residuals, before}};
  ScoreTest test;
  double amount = range.first;
  for (; test.evaluations < kMost;) {
    ++test.evaluations;
    std::optional<Eigen::VectorXd> there = residuals(amount, none);
    if (!there || there->size() != fitted.point().residuals.size() || !there->allFinite()) {
      // Too much of it, perhaps.
      if (tried.size() > 1) break;
      amount /= 8;
      if (amount < range.least && range.least > 0) break;
      continue;
    }
    const Followed followed = fitted.Of(*there);
    tried.push_back({amount, *std::move(there), followed});
    std::sort(tried.begin(), tried.end(), [](const Tried& a, const Tried& b) { return a.amount < b.amount; });
    if (range.least == range.greatest) break;
    amount = BestAmount(fitted, range, tried);
    const bool is_known = std::any_of(tried.begin(), tried.end(), [&](const Tried& one) {
      return std::abs(one.amount - amount) <= kSame * std::max(std::abs(one.amount), std::abs(amount));
    });
    if (is_known || std::abs(amount) < 1e-9 * std::abs(range.first)) break;
  }
  if (tried.size() < 2) return std::nullopt;
  const Tried* best = nullptr;
  for (const Tried& one : tried)
    if (one.amount != 0 && (!best || one.followed.cost < best->followed.cost)) best = &one;
  test.amount = best->amount;
  test.cost = best->followed.cost;
  test.step = best->followed.step;
  test.direction = fitted.Of(best->residuals - fitted.point().residuals).left;
  return test;
}

void Confirm(const FollowedCost& fitted, const AmountRange& range, const ResidualsOf& residuals, ScoreTest& test) {
  constexpr int kRounds = 3;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(test.step.size());
  const std::optional<Eigen::VectorXd> alone = residuals(test.amount, none);
  ++test.evaluations;
  if (!alone) return;
  // By a relative change of the amount.
  const Eigen::VectorXd column = *alone - fitted.point().residuals;
  FittedPoint both = fitted.point();
  const Index n = both.jacobian.cols();
  both.jacobian.conservativeResize(Eigen::NoChange, n + 1);
  both.jacobian.col(n) = column;
  const FollowedCost together(std::move(both));
  double best = std::numeric_limits<double>::infinity();
  double amount = test.amount;
  Eigen::VectorXd step = test.step;
  double share = 1;
  for (int round = 0; round < kRounds; ++round) {
    ++test.evaluations;
    const std::optional<Eigen::VectorXd> there = residuals(amount, step);
    const double cost = there ? fitted.point().loss.Cost(*there) : std::numeric_limits<double>::infinity();
    if (cost < best) {
      best = cost;
      test.amount = amount;
      test.step = step;
    } else {
      share /= 3;
    }
    if (!there) {
      step *= 0.5;
      continue;
    }
    const Followed next = together.Of(*there);
    step += share * next.step.head(n);
    amount = std::clamp(amount * (1 + share * std::clamp(next.step[n], -0.7, 2.0)), range.least, range.greatest);
  }
  test.cost = best;
}

double EffectiveResiduals(const Eigen::VectorXd& residuals, const ResidualStructure& structure) {
  double effective = static_cast<double>(residuals.size());
  for (const ResidualSeries& series : structure.series) {
    if (series.count < 4) continue;
    double squares = 0;
    double products = 0;
    for (Index i = 0; i < series.count; ++i) {
      const double here = residuals[series.first + i * series.step];
      squares += here * here;
      if (i + 1 < series.count) products += here * residuals[series.first + (i + 1) * series.step];
    }
    if (!(squares > 0)) continue;
    const auto n = static_cast<double>(series.count);
    const double correlation = std::clamp(products / squares * n / (n - 1), 0.0, 0.999);
    // Of white noise it is 1/sqrt(n) by chance.
    const double beyond = correlation > 2 / std::sqrt(n) ? correlation : 0;
    effective -= n - std::max(2.0, n * (1 - beyond) / (1 + beyond));
  }
  return std::max(effective, 4.0);
}

double CriterionChange(double cost_before, double cost, double effective, int parameters, std::size_t additions) {
  if (!(cost > 0) || !(cost_before > 0)) return 0;
  return effective * std::log(cost / cost_before) + parameters * std::log(effective) +
         2 * std::max(parameters, 1) * std::log(static_cast<double>(std::max<std::size_t>(additions, 1)));
}

}  // namespace fourpost
