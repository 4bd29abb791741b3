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
  Eigen::VectorXd remainder;
  Followed followed;
};

/// What is left at an amount, linear between those that are known and on from the outermost. `tried`: by amount, 0
/// among them.
Eigen::VectorXd Interpolated(const std::vector<Tried>& tried, double amount) {
  std::size_t after = 1;
  while (after + 1 < tried.size() && tried[after].amount < amount) ++after;
  const Tried& a = tried[after - 1];
  const Tried& b = tried[after];
  return a.remainder + (amount - a.amount) / (b.amount - a.amount) * (b.remainder - a.remainder);
}

/// Of what is left by interpolation, on a grid that is refined once.
double BestAmount(const RobustLoss& loss, const AmountRange& range, const std::vector<Tried>& tried) {
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
      const double cost = loss.Cost(Interpolated(tried, amount));
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

FollowedCost::FollowedCost(FittedPoint point)
    : point_(std::move(point)), weights_(point_.loss.Weights(point_.residuals)), normal_(Normal(weights_)) {}

Eigen::LDLT<Eigen::MatrixXd> FollowedCost::Normal(const Eigen::VectorXd& weights) const {
  // A variable may move by its range, or by a factor e: weak, and enough where nothing else determines it.
  constexpr double kLoose = 1e-3;
  Eigen::MatrixXd normal = point_.jacobian.transpose() * weights.asDiagonal() * point_.jacobian;
  const double scale = normal.diagonal().size() > 0 ? normal.diagonal().maxCoeff() : 1;
  normal.diagonal().array() += kLoose * std::min(1.0, scale) + 1e-12 * scale;
  return normal.ldlt();
}

Eigen::VectorXd FollowedCost::Remainder(const Eigen::VectorXd& residuals) const {
  return residuals - point_.jacobian * normal_.solve(point_.jacobian.transpose() * weights_.cwiseProduct(residuals));
}

Eigen::VectorXd FollowedCost::Weighted(const Eigen::VectorXd& residuals) const {
  return weights_.cwiseSqrt().cwiseProduct(residuals);
}

Eigen::VectorXd FollowedCost::Slope() const {
  return point_.jacobian.transpose() * weights_.cwiseProduct(point_.residuals);
}

Followed FollowedCost::Of(const Eigen::VectorXd& residuals) const {
  constexpr int kRounds = 3;
  Followed followed;
  const Eigen::MatrixXd& jacobian = point_.jacobian;
  const Index n = jacobian.cols();
  followed.step = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd now = residuals;
  const int rounds = point_.loss.kind() == LossKind::kNone ? 1 : kRounds;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::VectorXd weights = point_.loss.Weights(now);
    followed.step = -Normal(weights).solve(jacobian.transpose() * weights.cwiseProduct(residuals));
    now = residuals + jacobian * followed.step;
  }
  followed.cost = point_.loss.Cost(now);
  followed.left = std::move(now);
  return followed;
}

double LeastPromise(double cost, Index residuals, std::size_t additions) {
  const auto count = static_cast<double>(residuals);
  const double share = -std::expm1(-2 * std::log(static_cast<double>(additions)) / count);
  return 0.5 * share * std::max(cost, count);
}

namespace {

std::vector<Tried> NothingTried(const FollowedCost& fitted) {
  std::vector<Tried> tried(1);
  tried.front().remainder = fitted.Remainder(fitted.point().residuals);
  return tried;
}

void Add(const FollowedCost& fitted, double amount, const Eigen::VectorXd& residuals, std::vector<Tried>& tried) {
  tried.push_back({amount, residuals, fitted.Remainder(residuals), fitted.Of(residuals)});
  std::sort(tried.begin(), tried.end(), [](const Tried& a, const Tried& b) { return a.amount < b.amount; });
}

bool IsTried(const std::vector<Tried>& tried, double amount) {
  constexpr double kSame = 0.15;
  return std::any_of(tried.begin(), tried.end(), [&](const Tried& one) {
    return std::abs(one.amount - amount) <= kSame * std::max(std::abs(one.amount), std::abs(amount));
  });
}

/// The best amount of those that were tried, but 0.
ScoreTest BestOf(std::vector<Tried>& tried) {
  Tried* best = nullptr;
  for (Tried& one : tried)
    if (one.amount != 0 && (!best || one.followed.cost < best->followed.cost)) best = &one;
  ScoreTest test;
  test.amount = best->amount;
  test.cost = best->followed.cost;
  test.step = best->followed.step;
  test.left = best->followed.left;
  test.alone = std::move(best->residuals);
  return test;
}

}  // namespace

ScoreTest TestToFirstOrder(const FollowedCost& fitted, const AmountRange& range, const Eigen::VectorXd& at_first) {
  constexpr int kMost = 4;
  const Eigen::VectorXd change = (at_first - fitted.point().residuals) / range.first;
  std::vector<Tried> tried = NothingTried(fitted);
  Add(fitted, range.first, at_first, tried);
  // The best amount is looked for some times as far as has been tried.
  while (range.least != range.greatest && tried.size() < kMost) {
    const double amount = BestAmount(fitted.point().loss, range, tried);
    if (IsTried(tried, amount)) break;
    Add(fitted, amount, fitted.point().residuals + amount * change, tried);
  }
  return BestOf(tried);
}

std::optional<ScoreTest> TestAmount(const FollowedCost& fitted, const AmountRange& range, const ResidualsOf& residuals,
                                    double least_promise) {
  constexpr int kMost = 4;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(fitted.point().jacobian.cols());
  std::vector<Tried> tried = NothingTried(fitted);
  const double none_added = fitted.point().loss.Cost(tried.front().remainder);
  int evaluations = 0;
  double amount = range.first;
  while (evaluations < kMost) {
    ++evaluations;
    std::optional<Eigen::VectorXd> there = residuals(amount, none);
    if (!there || there->size() != fitted.point().residuals.size() || !there->allFinite()) {
      // Too much of it, perhaps.
      if (tried.size() > 1) break;
      amount /= 8;
      if (amount < range.least && range.least > 0) break;
      continue;
    }
    Add(fitted, amount, *there, tried);
    if (range.least == range.greatest) break;
    amount = BestAmount(fitted.point().loss, range, tried);
    const double promise = none_added - fitted.point().loss.Cost(Interpolated(tried, amount));
    if (promise < least_promise) break;
    if (IsTried(tried, amount) || std::abs(amount) < 1e-9 * std::abs(range.first)) break;
  }
  if (tried.size() < 2) return std::nullopt;
  ScoreTest test = BestOf(tried);
  test.evaluations = evaluations;
  return test;
}

void Confirm(const FollowedCost& fitted, const AmountRange& range, const ResidualsOf& residuals, ScoreTest& test) {
  constexpr int kMost = 7;
  constexpr int kMostShorter = 3;
  constexpr double kShorter = 0.3;
  constexpr double kStill = 0.01;
  const Index n = test.step.size();
  const Eigen::VectorXd column = (test.alone - fitted.point().residuals) / test.amount;
  double amount = 0;
  Eigen::VectorXd step = Eigen::VectorXd::Zero(n);
  const double before = fitted.point().loss.Cost(fitted.point().residuals);
  double cost = before;
  double amount_ahead = test.amount;
  Eigen::VectorXd step_ahead = test.step;
  int shorter = 0;
  test.left = fitted.point().residuals;
  for (int round = 0; round < kMost && shorter < kMostShorter; ++round) {
    ++test.evaluations;
    const double next_amount = range.least == range.greatest ? range.first : amount + amount_ahead;
    const std::optional<Eigen::VectorXd> there =
        residuals(std::clamp(next_amount, range.least, range.greatest), step + step_ahead);
    const double next_cost = there ? fitted.point().loss.Cost(*there) : std::numeric_limits<double>::infinity();
    if (!(next_cost < cost)) {
      amount_ahead *= kShorter;
      step_ahead *= kShorter;
      ++shorter;
      continue;
    }
    shorter = 0;
    const bool is_end = cost - next_cost < kStill * (before - next_cost);
    cost = next_cost;
    amount = std::clamp(next_amount, range.least, range.greatest);
    step += step_ahead;
    test.left = *there;
    if (is_end) break;
    FittedPoint both = fitted.point();
    both.jacobian.conservativeResize(Eigen::NoChange, n + 1);
    // By its size: it may become some times larger, or vanish.
    both.jacobian.col(n) = amount * column;
    const Followed next = FollowedCost(std::move(both)).Of(*there);
    step_ahead = next.step.head(n);
    amount_ahead = amount * std::clamp(next.step[n], -0.7, 2.0);
  }
  test.cost = cost;
  test.step = step;
  // Not by the way back to an optimum that the fitted point lies beside.
  test.is_confirmed = cost < std::min(before, fitted.Of(fitted.point().residuals).cost);
  if (test.is_confirmed) test.amount = amount;
}

double EffectiveResiduals(const Eigen::VectorXd& residuals, const ResidualStructure& structure) {
  double effective = static_cast<double>(residuals.size());
  for (const ResidualSeries& series : structure.series) {
    effective -= static_cast<double>(series.unmeasured);
    double squares = 0;
    double products = 0;
    // Of neighbours that were both measured; the others are 0.
    Index pairs = 0;
    for (Index i = 0; i < series.count; ++i) {
      const double here = residuals[series.first + i * series.step];
      squares += here * here;
      if (i + 1 == series.count) break;
      const double next = residuals[series.first + (i + 1) * series.step];
      products += here * next;
      pairs += here != 0 && next != 0 ? 1 : 0;
    }
    const auto n = static_cast<double>(series.measured());
    if (n < 4 || pairs == 0) continue;
    const double correlation = std::clamp(products / squares * n / static_cast<double>(pairs), 0.0, 0.999);
    // Of white noise it is 1/sqrt(n) by chance.
    const double beyond = correlation > 2 / std::sqrt(n) ? correlation : 0;
    effective -= n - std::max(2.0, n * (1 - beyond) / (1 + beyond));
  }
  return std::max(effective, 4.0);
}

double CriterionChange(double cost_before, double cost, Index residuals, double effective, int parameters,
                       std::size_t additions, int choices) {
  if (!(cost > 0) || !(cost_before > 0)) return 0;
  const double missing = std::max(0.0, static_cast<double>(residuals) - cost_before);
  return effective * std::log((cost + missing) / (cost_before + missing)) + parameters * std::log(effective) +
         2 * choices * std::log(static_cast<double>(std::max<std::size_t>(additions, 1)));
}

}  // namespace fourpost
