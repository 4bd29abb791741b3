#pragma once

#include <deque>

#include <Eigen/Core>

namespace fourpost {

/// Anderson acceleration of a fixed-point iteration x <- g(x): with f = g(x) - x and the differences DX, DF of the last
/// iterates and their f,
///   x <- x + f - (DX + DF) c,   c = argmin |f - DF c|.
/// Source: H. F. Walker and P. Ni, Anderson acceleration for fixed-point iterations, SIAM J. Numer. Anal. 49 (2011),
/// eq. 2.5; on a linear g it is GMRES. Scale x so that its entries compare.
class AndersonAcceleration {
 public:
  /// `history`: differences kept; 0 is the plain iteration.
  explicit AndersonAcceleration(int history) : history_(static_cast<std::size_t>(history)) {}

  /// The iterate after `x`, whose plain step is `f` = g(x) - x.
  Eigen::VectorXd Next(const Eigen::VectorXd& x, const Eigen::VectorXd& f);

 private:
  std::size_t history_;
  std::deque<Eigen::VectorXd> iterate_changes_;
  std::deque<Eigen::VectorXd> step_changes_;
  Eigen::VectorXd iterate_;
  Eigen::VectorXd step_;
};

}  // namespace fourpost
