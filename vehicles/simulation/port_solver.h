#pragma once

#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/port.h"

namespace fourpost {

/// Finds the remainders r of all ports at one instant, where extension and rate of each depend on them:
///   r_j = R_j(e_j, e'_j),  e = extension + by_extension r,  e' = rate + by_rate r
/// by Newton's method on r - R, from where it was the time before, halving steps that lead away. Where laws have kinks
/// it ends after some iterations in the right pieces. Keeps its memory: nothing is allocated after construction.
class PortSolver {
 public:
  explicit PortSolver(const std::vector<Port>& ports);

  /// ports x ports: what remainders do to extensions [m/N] and to rates [m/s/N].
  void SetCompliance(const Eigen::MatrixXd& by_extension, const Eigen::MatrixXd& by_rate);

  /// Whether it converged; `remainder` holds the start and becomes the solution, or the best iterate.
  bool Solve(const Eigen::VectorXd& extension, const Eigen::VectorXd& rate, Eigen::VectorXd& remainder);

 private:
  /// Residual at `remainder`; its largest entry.
  double Evaluate(const Eigen::VectorXd& extension, const Eigen::VectorXd& rate, const Eigen::VectorXd& remainder);
  void NewtonStep();

  std::vector<PortLaw> laws_;
  Eigen::MatrixXd by_extension_;
  Eigen::MatrixXd by_rate_;
  Eigen::VectorXd extension_;
  Eigen::VectorXd rate_;
  Eigen::VectorXd law_;
  Eigen::VectorXd residual_;
  Eigen::VectorXd trial_;
  Eigen::VectorXd step_;
  Eigen::MatrixXd jacobian_;
  /// Largest remainder so far [N].
  double largest_ = 0;
};

}  // namespace fourpost
