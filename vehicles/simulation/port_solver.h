#pragma once

#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/port.h"
#include "vehicles/simulation/friction_step.h"
#include "vehicles/simulation/hydraulic_step.h"

namespace fourpost {

/// Finds the nonlinear forces r of all ports at the end of a step, where extension and rate of each depend on them:
///   r_j = R_j(e_j, e'_j),  e = extension + by_extension r,  e' = rate + by_rate r
/// For a hydraulic damper, e' is replaced by the extension x of the spring in its linear part, see HydraulicStep.
/// Newton's method on r - R, from the previous solution, halving steps that increase the residual. With kinked laws it
/// reaches the right pieces after some iterations. Keeps its memory: solving allocates nothing.
class PortSolver {
 public:
  /// `step_s`: time step of ports with memory from one solution to the next.
  PortSolver(const std::vector<Port>& ports, double step_s);

  /// Resets ports with memory to rest.
  void Rest();
  /// Friction without force at this extension.
  void RestFriction(Eigen::Index port, double extension);

  /// ports x ports, or of the first ones alone: extensions [m/N] and rates [m/s/N] per nonlinear force.
  void SetCompliance(const Eigen::MatrixXd& by_extension, const Eigen::MatrixXd& by_rate);

  /// Solves for the first `count` ports; the nonlinear forces of the others are zero. Returns whether it converged;
  /// `remainder` holds the start and becomes the solution, or the best iterate.
  bool Solve(Eigen::Index count, const Eigen::VectorXd& extension, const Eigen::VectorXd& rate,
             Eigen::VectorXd& remainder);

  /// Of the last solution, not of hydraulic dampers: how much more force another law gives at its extension and rate,
  /// of friction from the same start [N].
  double Departure(Eigen::Index port, const PortLaw& law) const;
  /// How the last solution changes, to first order, where extension and rate without the forces, and the laws' own
  /// forces, change by these; ports x changes. `forces` becomes the changes of the solution.
  void Change(const Eigen::Ref<const Eigen::MatrixXd>& extension, const Eigen::Ref<const Eigen::MatrixXd>& rate,
              Eigen::Ref<Eigen::MatrixXd> forces) const;

  /// Ports with memory accept the last solution as the end of their step.
  void Advance();

  /// Of friction, for the last solution: derivatives of its force by its extension and by its force at the step's
  /// start. For other ports zero.
  std::pair<double, double> ByStart(Eigen::Index port) const;

  /// Memory of each port, if it has one.
  using Memory = std::vector<std::variant<std::monostate, HydraulicStep, FrictionStep>>;
  const Memory& memory() const { return memory_; }
  /// Restores the memory of the ports at another step's start.
  void Remember(const Memory& memory) { memory_ = memory; }
  /// That of friction alone.
  void RememberFriction(const Memory& memory);

 private:
  /// Residual at `remainder`; its largest entry, NaN if a law has no solution.
  double Evaluate(const Eigen::VectorXd& extension, const Eigen::VectorXd& rate, const Eigen::VectorXd& remainder);
  void NewtonStep();
  /// By extension and by rate, at the last iterate.
  std::pair<double, double> SlopesOf(Eigen::Index port) const;

  std::vector<PortLaw> laws_;
  /// Number of ports being solved for.
  Eigen::Index active_ = 0;
  Memory memory_;
  Eigen::MatrixXd by_extension_;
  Eigen::MatrixXd by_rate_;
  Eigen::VectorXd extension_;
  Eigen::VectorXd rate_;
  Eigen::VectorXd law_;
  Eigen::VectorXd residual_;
  Eigen::VectorXd trial_;
  Eigen::VectorXd step_;
  /// Slopes of the laws.
  Eigen::VectorXd on_extension_;
  Eigen::VectorXd on_rate_;
  Eigen::MatrixXd jacobian_;
  /// Largest nonlinear force so far, or the force to which those of ports with memory are rounded [N].
  double largest_ = 0;
};

}  // namespace fourpost
