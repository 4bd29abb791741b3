#pragma once

#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/lacking_forces.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/simulation/condensed_stepper.h"
#include "vehicles/simulation/friction_step.h"
#include "vehicles/simulation/hydraulic_step.h"

namespace fourpost {

/// Time integration of the full multibody system, by steps of its reduced model. The reduced model moves like the full
/// system under the difference g of their forces:
///   g = force that the reduced vehicle needs to move as [s x](t) - that of the full system (LackingForces).
/// Linear parts of both cancel, and so do most of the kinks of their laws: g is small and smooth, and linear in time
/// over a step H that consists of some shorter steps h of the CondensedStepper. Its value at the end, where both
/// systems agree, is extrapolated from the starts of the last two steps and iterated by Anderson acceleration, in some
/// two evaluations of the full system. The remaining error is of order H^2 in g, plus that of the reduced steps.
class FullStepper {
 public:
  /// `step_s`: H, of `parts` steps h. `multibody` must carry the parameters and preloads of `model`, and outlive this
  /// object. Throws std::invalid_argument for steps that are not positive.
  FullStepper(Multibody& multibody, const CondensedModel& model, double step_s, long parts);

  /// At rest in the design pose at time t, or in this state [s s' x] of the reduced model, where g follows from one
  /// evaluation, and where friction that sticks has come in one stroke; without hydraulic dampers then.
  void Start(const PostMotion& posts, double t, const Eigen::VectorXd& released = {});

  /// One step H. Throws SimulationError if g is not found.
  void Step(const PostMotion& posts);

  /// Sensor readings.
  void Read(Eigen::Ref<Eigen::VectorXd> readings) const { readings = readings_; }

  const CondensedStepper& condensed() const { return stepper_; }

  /// Evaluations of the full system since Start().
  long evaluations() const { return evaluations_; }

 private:
  /// Steps the reduced model to the end, where g has this value.
  void StepParts(const PostMotion& posts, const Eigen::VectorXd& added);
  /// There, at time t.
  Eigen::VectorXd Lacking(double t);
  Eigen::VectorXd Memory(const Eigen::VectorXd& position);
  double MemoryExtension(std::size_t element, long part) const;
  void StartMemory(const Eigen::VectorXd& released);
  Eigen::VectorXd Position() const;
  /// Of forces on [s x], comparable with other sizes.
  double Size(const Eigen::VectorXd& forces) const { return forces.cwiseProduct(weights_).norm(); }

  LackingForces full_;
  long parts_;
  CondensedStepper stepper_;
  Eigen::MatrixXd mass_;
  Eigen::VectorXd weights_;
  double start_s_ = 0;
  long steps_ = 0;
  long evaluations_ = 0;
  /// g at the start of the step and a step before.
  Eigen::VectorXd added_;
  Eigen::VectorXd before_;
  CondensedStepper::Moment moment_;
  std::vector<PostState> posts_;
  /// Of the inertia of the motion so far.
  double largest_ = 0;
  LackingForces::Motion motion_;
  Eigen::VectorXd readings_;

  /// Elements with a memory, hydraulic dampers first, stepped through their extensions in the full system: at the start
  /// of the step and at its end.
  std::vector<Eigen::VectorXd> memory_directions_;
  std::vector<HydraulicStep> oil_at_start_;
  std::vector<HydraulicStep> oil_;
  std::vector<FrictionStep> frictions_at_start_;
  std::vector<FrictionStep> frictions_;
  /// Sliding forces of the latter [N].
  std::vector<double> sliding_;
  /// (parts + 1) x elements: extensions in the reduced model over the step; ...
  Eigen::MatrixXd extensions_;
  /// ... and the excess of those in the full system.
  Eigen::VectorXd extra_at_start_;
  Eigen::VectorXd extra_;
};

}  // namespace fourpost
