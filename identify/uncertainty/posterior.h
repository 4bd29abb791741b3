#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "identify/search/draws.h"

namespace fourpost {

/// A minimum of the cost, in the n variables that are drawn.
struct PosteriorOptimum {
  Eigen::VectorXd centre;
  double cost = 0;
  /// The cost rises by d'Hd at the distance d.
  Eigen::MatrixXd hessian;
  /// Of the cost at the centre, n: what noise of recorded inputs adds, and is to be taken off.
  Eigen::VectorXd slope;
};

/// What is known of the variables about one or several optima, flat within their bounds before the data.
///
/// At the first optimum it has the covariance S that intervals rest on, which takes account of more than the cost does:
/// of noise that is correlated or larger than stated, and of what the model lacks. The cost gives its shape: the log
/// density at the distance d of an optimum is
///   -(d'S^-1 d / d'Hd) (cost(x) - cost(optimum)) / 2,
/// exactly normal where the cost is a parabola (vertical scaling: Chandler and Bate, Biometrika 94, 2007, eq. 10).
/// Where S = T H^-1 that is -cost / 2T everywhere. At other optima, S follows H as at the first: S_k = A H_k^-1 A', A =
/// S^1/2 H^1/2. Their evidence, by Laplace, is exp(-cost_k / 2T) det(S_k)^1/2 times the share within bounds, T^n =
/// det(S H).
class Posterior {
 public:
  /// `covariance`: S at the first. One optimum needs no Hessian where its costs are not asked for.
  Posterior(const std::vector<PosteriorOptimum>& optima, const Eigen::MatrixXd& covariance, Eigen::VectorXd lower,
            Eigen::VectorXd upper);

  Eigen::Index size() const { return lower_.size(); }
  const Eigen::VectorXd& lower() const { return lower_; }
  const Eigen::VectorXd& upper() const { return upper_; }
  /// Of the evidence, one per optimum; they add up to 1.
  const std::vector<double>& shares() const { return shares_; }
  bool Holds(const Eigen::VectorXd& x) const;

  /// Of a point with this cost, up to a constant; minus infinity beyond the bounds and for a cost that is not finite.
  double LogDensity(const Eigen::VectorXd& x, double cost) const;
  /// Of a mixture of normal distributions about the optima, up to a constant.
  double LogNormal(const Eigen::VectorXd& x) const;
  /// Point number `i` of that mixture within the bounds, optima in proportion to their evidence. Those of the first lie
  /// about a point that is `moved` from it by a share between 0 and 1, as far as the bounds let it; empty: not moved.
  Eigen::VectorXd DrawNormal(std::uint64_t seed, std::size_t i, const Eigen::VectorXd& moved = {}) const;

 private:
  struct Mode {
    PosteriorOptimum optimum;
    Eigen::MatrixXd precision;
    Eigen::MatrixXd root;
    double log_determinant = 0;
    double log_within = 0;
    double log_share = 0;
  };

  void AddMode(const PosteriorOptimum& optimum, const Eigen::MatrixXd& covariance);
  void SetShares(double temperature);
  /// Share of plain draws within the bounds.
  double LogWithin(const Mode& mode) const;
  double LogNormalOf(const Mode& mode, const Eigen::VectorXd& x) const;
  /// The largest share of a move that stays within the bounds, 1 at most.
  double ShareWithin(const Eigen::VectorXd& from, const Eigen::VectorXd& moved) const;
  const Mode& NearestTo(const Eigen::VectorXd& x) const;

  Eigen::VectorXd lower_;
  Eigen::VectorXd upper_;
  std::vector<Mode> modes_;
  std::vector<double> shares_;
  double temperature_ = 1;
};

}  // namespace fourpost
