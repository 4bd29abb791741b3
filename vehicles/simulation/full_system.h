#pragma once

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/simulation/time_system.h"

namespace fourpost {

/// The full nonlinear multibody system in time, by FullStepper: several times as fast as MultibodySystem, which checks
/// it.
class FullSystem : public TimeSystem {
 public:
  struct Steps {
    /// Of the forces that linear kinematics leave out: whole parts of what Run() reports in, none longer [s].
    double longest_s = 4e-3;
    /// Of the condensed model: whole parts of those [s].
    double longest_part_s = 5e-4;
  };

  /// `multibody` must carry the parameters and preloads of `model`; both must outlive this object. Throws
  /// std::invalid_argument for steps that are not positive.
  FullSystem(Multibody& multibody, const CondensedModel& model, Steps steps);

  /// Throws SimulationError where the motion grows beyond all numbers, or where it cannot be found.
  void Run(const PostMotion& posts, double start, double step, const ReadingSink& sink,
           const std::function<bool()>& done) override;

  /// Of the full system, in the last run.
  long evaluations() const { return evaluations_; }

 private:
  Multibody& multibody_;
  const CondensedModel& model_;
  Steps steps_;
  long evaluations_ = 0;
};

}  // namespace fourpost
