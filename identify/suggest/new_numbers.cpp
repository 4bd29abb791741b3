#include "identify/suggest/new_numbers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fourpost {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

class NumberFit {
 public:
  NumberFit(const FollowedCost& fitted, const NewNumbers& numbers, ScoreTest& test)
      : fitted_(fitted), numbers_(numbers), test_(test), at_(Within(numbers.first)) {}

  VectorXd Run() {
    constexpr int kMost = 4;
    constexpr double kStill = 0.01;
    const double before = fitted_.point().loss.Cost(fitted_.point().residuals);
    for (int round = 0; round < kMost; ++round) {
      const double cost = test_.cost;
      if (!Step() || cost - test_.cost < kStill * (before - test_.cost)) break;
    }
    return at_;
  }

 private:
  VectorXd Within(const VectorXd& numbers) const { return numbers.cwiseMax(numbers_.lower).cwiseMin(numbers_.upper); }

  /// False where no part of it lowers the cost.
  bool Step() {
    constexpr int kMostShorter = 3;
    constexpr double kShorter = 0.3;
    const Index n = test_.step.size();
    const VectorXd ahead = Ahead();
    double share = 1;
    for (int i = 0; i < kMostShorter; ++i, share *= kShorter) {
      const VectorXd numbers = Within(at_ + share * ahead.tail(at_.size()));
      const VectorXd step = test_.step + share * ahead.head(n);
      std::optional<VectorXd> there = At(numbers, step);
      if (!there) continue;
      const double cost = fitted_.point().loss.Cost(*there);
      if (!(cost < test_.cost)) continue;
      at_ = numbers;
      test_.step = step;
      test_.cost = cost;
      test_.left = *std::move(there);
      return true;
    }
    return false;
  }

  /// Of the variables, then of the numbers: shortened so that no number moves by more than its law can be trusted for.
  VectorXd Ahead() {
    constexpr double kFarthest = 1;
    FittedPoint both = fitted_.point();
    const Index n = both.jacobian.cols();
    both.jacobian.conservativeResize(Eigen::NoChange, n + at_.size());
    for (Index j = 0; j < at_.size(); ++j) both.jacobian.col(n + j) = Column(j);
    VectorXd ahead = FollowedCost(std::move(both)).Of(test_.left).step;
    const double farthest = ahead.tail(at_.size()).cwiseAbs().maxCoeff();
    if (farthest > kFarthest) ahead *= kFarthest / farthest;
    return ahead;
  }

  /// Zero where it cannot be evaluated, and of a number that the cost would take beyond its bound.
  VectorXd Column(Index j) {
    // Of a number with a logarithm, whose variable may have any size; of a share, as of a force from 0 on, of its size.
    constexpr double kRelative = 0.02;
    constexpr double kLeast = 1e-4;
    const bool is_share = numbers_.lower[j] == 0 && numbers_.upper[j] == 1;
    double ahead = is_share ? std::max(kLeast, kRelative * at_[j]) : kRelative;
    if (at_[j] + ahead > numbers_.upper[j]) ahead = -ahead;
    VectorXd numbers = at_;
    numbers[j] += ahead;
    const std::optional<VectorXd> there = At(numbers, test_.step);
    if (!there) return VectorXd::Zero(test_.left.size());
    const VectorXd column = (*there - test_.left) / ahead;
    const double slope = column.dot(fitted_.point().loss.Weights(test_.left).cwiseProduct(test_.left));
    const bool is_held = slope > 0 ? at_[j] <= numbers_.lower[j] : at_[j] >= numbers_.upper[j];
    return is_held ? VectorXd::Zero(column.size()) : column;
  }

  std::optional<VectorXd> At(const VectorXd& numbers, const VectorXd& step) {
    ++test_.evaluations;
    return numbers_.residuals(numbers, step);
  }

  const FollowedCost& fitted_;
  const NewNumbers& numbers_;
  ScoreTest& test_;
  VectorXd at_;
};

}  // namespace

VectorXd FitNumbers(const FollowedCost& fitted, const NewNumbers& numbers, ScoreTest& test) {
  return NumberFit(fitted, numbers, test).Run();
}

}  // namespace fourpost
