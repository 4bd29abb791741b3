#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/port.h"
#include "vehicles/simulation/hydraulic_step.h"

namespace fourpost {

/// Finds the remainders r of all ports at the end of a step, where extension and rate of each depend on them:
///   r_j = R_j(e_j, e'_j),  e = extension + by_extension r,  e' = rate + by_rate r
/// A hydraulic damper's has the place of e' for the extension x of the spring in its linear share, see HydraulicStep.
/// by Newton's method on r - R, from where it was the time before, halving steps that lead away. Where laws have kinks
/// it ends after some iterations in the right pieces. Keeps its memory: solving allocates nothing.
class PortSolver {
 public:
  /// `step_s`: by which ports with memory go on from one solution to the next.
  PortSolver(const std::vector<Port>& ports, double step_s);

  /// Ports with memory have been at rest ever since.
  void Rest();

  /// ports x ports, or of the first ones alone: what remainders do to extensions [m/N] and to rates [m/s/N].
  void SetCompliance(const Eigen::MatrixXd& by_extension, const Eigen::MatrixXd& by_rate);

  /// Of the first `count` ports; the remainders of the others are zero. Whether it converged; `remainder` holds the
  /// start and becomes the solution, or the best iterate.
  bool Solve(Eigen::Index count, const Eigen::VectorXd& extension, const Eigen::VectorXd& rate,
             Eigen::VectorXd& remainder);

  /// Ports with memory take the last solution for the end of their step.
  void Advance();

  /// Of each port, if it has one.
  using Memory = std::vector<std::optional<HydraulicStep>>;
  const Memory& memory() const { return hydraulics_; }
  /// Goes back to what ports remembered at another step's start.
  void Remember(const Memory& memory) { hydraulics_ = memory; }

 private:
  /// Residual at `remainder`; its largest entry, NaN where a law has no answer.
  double Evaluate(const Eigen::VectorXd& extension, const Eigen::VectorXd& rate, const Eigen::VectorXd& remainder);
  void NewtonStep();

  std::vector<PortLaw> laws_;
  /// How many are being solved for.
  Eigen::Index active_ = 0;
  /// Of each port, if it is a hydraulic damper's.
  Memory hydraulics_;
  Eigen::MatrixXd by_extension_;
  Eigen::MatrixXd by_rate_;
  Eigen::VectorXd extension_;
  Eigen::VectorXd rate_;
  Eigen::VectorXd law_;
  Eigen::VectorXd residual_;
  Eigen::VectorXd trial_;
  Eigen::VectorXd step_;
  Eigen::MatrixXd jacobian_;
  /// Largest remainder so far, or what those of ports with memory are rounded at [N].
  double largest_ = 0;
};

}  // namespace fourpost
