#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "analysis/numerics/anderson_acceleration.h"
#include "analysis/process/deadline.h"
#include "vehicles/condensed/port.h"
#include "vehicles/condensed/receptance.h"
#include "vehicles/response/cycle_transform.h"
#include "vehicles/response/mean_slope_step.h"

namespace fourpost {

/// One cycle of the extensions of a vehicle's nonlinear elements, at given numbers of harmonics and samples: the
/// harmonics E, (H + 1) x ports, for which
///   E = driven + receptance R(E),
/// R: harmonics of the nonlinear forces at the signals of E, sampled over the cycle.
///
/// Fixed-point iteration is used while it converges fast, as for dashpots whose rates differ little. Otherwise, for
/// knees, stops, lift-off and hydraulic dampers, Newton's method with the slopes of the nonlinear forces. If the number
/// of harmonics makes its matrix too costly, Anderson acceleration: with friction of steps with the means of the slopes
/// (MeanSlopeStep), and where that fails without, with a hydraulic damper of Newton's method for the lowest harmonics.
class PortCycle {
 public:
  /// Both must outlive this object.
  PortCycle(const std::vector<Port>& ports, const Receptance& receptance, int harmonics, int samples);

  int harmonics() const { return transform_.harmonics(); }
  /// Steps per cycle for laws with memory.
  Eigen::Index steps() const { return steps_.samples(); }
  Eigen::Index samples() const { return transform_.samples(); }

  /// `driven`, `start`: harmonics 0, 1, .. of the extensions without nonlinear forces, and initial ones; any number of
  /// them, the others are zero. `tolerance`: see HarmonicBalanceOptions. Returns whether it converged; if not, the
  /// solution is the last iterate. Throws TimedOut after the deadline.
  bool Solve(double omega, const Eigen::MatrixXcd& driven, const Eigen::MatrixXcd& start, double tolerance,
             int max_iterations, const Deadline& deadline = {});

  /// (H + 1) x ports: extensions [m] and nonlinear forces [N] of the last solution.
  const Eigen::MatrixXcd& extension() const { return extension_; }
  const Eigen::MatrixXcd& remainder() const { return remainder_; }
  /// Nonlinear forces at the last solution's lower harmonics, sampled by another transform; zero for laws with memory.
  Eigen::MatrixXcd RemainderBy(const CycleTransform& transform) const;

  /// Samples x ports of the last solution: extensions, empty if no port uses them, rates and nonlinear forces; the
  /// latter kink-corrected, and zero for laws with memory.
  const Eigen::MatrixXd& extension_time() const { return extension_time_; }
  const Eigen::MatrixXd& rate_time() const { return rate_time_; }
  const Eigen::MatrixXd& remainder_time() const { return remainder_time_; }
  /// See Receptance::Ports.
  const Eigen::MatrixXcd& receptance() const { return ports_receptance_; }
  const std::vector<PortKink>& kinks(Eigen::Index port) const { return kinks_[static_cast<std::size_t>(port)]; }
  /// For one port at each step of a law with memory, steps x 1.
  struct SteppedMotion {
    Eigen::MatrixXd extension;
    Eigen::MatrixXd rate;
  };
  SteppedMotion StepsOf(Eigen::Index port) const;
  double omega() const { return omega_; }
  double Period() const;
  const std::vector<Port>& ports() const { return ports_; }

  /// Harmonics of the nonlinear force if this port had this law with memory.
  Eigen::VectorXcd RemainderOf(const PortLaw& law, Eigen::Index port) const;

  /// Whether sharp transitions of the forces, such as friction's, have a sample each time they are passed at full
  /// velocity.
  bool ResolvesSteps() const;

  /// Iterations of the last solution.
  int iterations() const { return iterations_; }

 private:
  bool Iterate(double tolerance, int most, const Deadline& deadline);
  bool IsPreconditioned() const { return has_memory_ || means_help_; }
  void FindRemainders();
  double FindStep();
  double SizeOf(const Eigen::MatrixXcd& extension) const;
  enum class Method { kPlain, kNewton, kAnderson };
  static bool IsEnough(double change, double earlier, Method method, double tolerance);
  Method FirstMethod() const;
  bool HasSteepFriction() const;
  Method Choose(double change, double before, double earlier, double tolerance) const;
  double Precondition();
  Method Newton() const;
  bool IsTouched() const;
  void TakeNewtonStep();
  void FollowNewton(double step);
  void AndersonStep(AndersonAcceleration& acceleration);
  Eigen::Index NewtonRows() const;

  const std::vector<Port>& ports_;
  const Receptance& receptance_;
  const CycleTransform& transform_;
  std::vector<std::vector<PortKink>> kinks_;
  /// Transform with more samples, over which ports with memory step through the cycle.
  const CycleTransform& steps_;
  bool uses_extension_ = false;
  bool has_memory_ = false;
  bool has_friction_ = false;
  /// Whether MeanSlopeStep takes part.
  bool means_help_ = false;
  double omega_ = 0;
  int iterations_ = 0;
  Eigen::MatrixXcd driven_;
  Eigen::MatrixXcd ports_receptance_;
  Eigen::MatrixXcd extension_;
  Eigen::MatrixXcd remainder_;
  Eigen::MatrixXcd step_;
  std::optional<MeanSlopeStep> preconditioner_;
  double preconditioned_ = 0;
  /// Harmonics of the extensions' rates.
  Eigen::MatrixXcd rate_;
  Eigen::MatrixXd extension_time_;
  Eigen::MatrixXd rate_time_;
  Eigen::MatrixXd remainder_time_;
};

}  // namespace fourpost
