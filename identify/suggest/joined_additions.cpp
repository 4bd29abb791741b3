#include "identify/suggest/joined_additions.h"

#include <algorithm>
#include <limits>

namespace fourpost {
namespace {

using Eigen::Index;

/// min |r + U a|^2 within 0 <= a <= 2, one share after the other; convex, so that every start ends in the same minimum.
Eigen::VectorXd Shares(const Eigen::MatrixXd& gram, const Eigen::VectorXd& pull) {
  constexpr double kMost = 2;
  constexpr int kRounds = 500;
  constexpr double kStill = 1e-9;
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(pull.size());
  for (int round = 0; round < kRounds; ++round) {
    double moved = 0;
    for (Index k = 0; k < pull.size(); ++k) {
      if (!(gram(k, k) > 0)) continue;
      const double best = shares[k] - (pull[k] + gram.row(k).dot(shares)) / gram(k, k);
      const double next = std::clamp(best, 0.0, kMost);
      moved = std::max(moved, std::abs(next - shares[k]));
      shares[k] = next;
    }
    if (moved < kStill) break;
  }
  return shares;
}

}  // namespace

JoinedAdditions JoinAdditions(const Eigen::VectorXd& before, const std::vector<Eigen::VectorXd>& with,
                              const std::function<bool(double, const Eigen::VectorXd&, std::size_t)>& pays) {
  constexpr std::size_t kMost = 6;
  const auto count = static_cast<Index>(with.size());
  Eigen::MatrixXd changes(before.size(), count);
  for (Index k = 0; k < count; ++k) changes.col(k) = with[static_cast<std::size_t>(k)] - before;
  const Eigen::MatrixXd gram = changes.transpose() * changes;
  const Eigen::VectorXd pull = changes.transpose() * before;

  JoinedAdditions joined;
  Eigen::VectorXd left_now = before;
  std::vector<Index> taken;
  while (taken.size() < std::min(kMost, with.size())) {
    std::vector<Index> best;
    Eigen::VectorXd best_shares;
    double least = std::numeric_limits<double>::infinity();
    for (Index k = 0; k < count; ++k) {
      if (std::find(taken.begin(), taken.end(), k) != taken.end()) continue;
      std::vector<Index> tried = taken;
      tried.push_back(k);
      const Eigen::VectorXd shares = Shares(gram(tried, tried), pull(tried));
      const double squares = shares.dot(gram(tried, tried) * shares) + 2 * shares.dot(pull(tried));
      if (!(squares < least)) continue;
      least = squares;
      best = tried;
      best_shares = shares;
    }
    if (best.empty()) break;  // nothing of them is finite
    const Eigen::VectorXd left = before + changes(Eigen::all, best) * best_shares;
    if (!pays(left_now.squaredNorm(), left, static_cast<std::size_t>(best.back()))) break;
    taken = best;
    joined.shares = best_shares;
    left_now = left;
  }
  joined.places.assign(taken.begin(), taken.end());
  return joined;
}

}  // namespace fourpost
