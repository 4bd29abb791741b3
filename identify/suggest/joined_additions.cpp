#include "identify/suggest/joined_additions.h"

#include <algorithm>
#include <optional>

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

using Change = std::function<double(double, const Eigen::VectorXd&, std::size_t)>;

class Joiner {
 public:
  Joiner(const Eigen::VectorXd& before, const std::vector<OfferedAddition>& offered, const Change& change)
      : before_(before), offered_(offered), change_(change), changes_(before.size(), std::ssize(offered)) {
    for (Index k = 0; k < changes_.cols(); ++k) changes_.col(k) = offered[static_cast<std::size_t>(k)].left - before;
    gram_ = changes_.transpose() * changes_;
    pull_ = changes_.transpose() * before;
  }

  JoinedAdditions Run() {
    constexpr std::size_t kMost = 6;
    // Each lowers the criterion, so that no set comes again; rounding must not go round for ever.
    constexpr int kMostRounds = 30;
    for (int round = 0; round < kMostRounds && taken_.size() < kMost; ++round) {
      const std::optional<Index> next = Next();
      if (!next) break;
      taken_.push_back(*next);
      while (Exchange()) continue;
    }
    JoinedAdditions joined{
        .places = {taken_.begin(), taken_.end()}, .shares = Shares(gram_(taken_, taken_), pull_(taken_)), .worth = {}};
    for (std::size_t i = 0; i < taken_.size(); ++i) joined.worth.push_back(Worth(taken_[i], Without(i)));
    return joined;
  }

 private:
  using Set = std::vector<Index>;

  std::size_t ThingOf(Index k) const { return offered_[static_cast<std::size_t>(k)].thing; }

  Set Without(std::size_t i) const {
    Set others = taken_;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    return others;
  }

  static Set With(Set set, Index k) {
    set.push_back(k);
    return set;
  }

  Eigen::VectorXd Left(const Set& set) const {
    if (set.empty()) return before_;
    return before_ + changes_(Eigen::all, set) * Shares(gram_(set, set), pull_(set));
  }

  /// Change of the criterion with one beside others.
  double Worth(Index k, const Set& others) const {
    return change_(Left(others).squaredNorm(), Left(With(others, k)), static_cast<std::size_t>(k));
  }

  /// By which the criterion falls most, of the things that are not taken; nothing where it falls by none.
  std::optional<Index> Next() const {
    std::optional<Index> best;
    double least = 0;
    for (Index k = 0; k < changes_.cols(); ++k) {
      if (std::any_of(taken_.begin(), taken_.end(), [&](Index one) { return ThingOf(one) == ThingOf(k); })) continue;
      const double worth = Worth(k, taken_);
      if (!(worth < least)) continue;
      least = worth;
      best = k;
    }
    return best;
  }

  /// Leaves one out, or takes an alternative for it. False where the criterion does not fall by that.
  bool Exchange() {
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      const Set others = Without(i);
      const double worth = Worth(taken_[i], others);
      if (!(worth < 0)) {
        taken_ = others;
        return true;
      }
      for (Index k = 0; k < changes_.cols(); ++k) {
        if (k == taken_[i] || ThingOf(k) != ThingOf(taken_[i]) || !(Worth(k, others) < worth)) continue;
        taken_[i] = k;
        return true;
      }
    }
    return false;
  }

  const Eigen::VectorXd& before_;
  const std::vector<OfferedAddition>& offered_;
  const Change& change_;
  Eigen::MatrixXd changes_;
  Eigen::MatrixXd gram_;
  Eigen::VectorXd pull_;
  Set taken_;
};

}  // namespace

JoinedAdditions JoinAdditions(const Eigen::VectorXd& before, const std::vector<OfferedAddition>& offered,
                              const Change& change) {
  return Joiner(before, offered, change).Run();
}

}  // namespace fourpost
