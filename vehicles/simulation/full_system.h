#pragma once

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/simulation/time_system.h"

namespace fourpost {

/// The full nonlinear multibody system in time, by FullStepper: several times as fast as MultibodySystem, which
/// verifies it.
class FullSystem : public TimeSystem {
 public:
  struct Steps {
    /// Step of the forces that linear kinematics leave out: a whole part of Run()'s output step, not longer than this
    /// [s].
    double longest_s = 4e-3;
    /// Step of the reduced model: a whole part of the former [s].
    double longest_part_s = 5e-4;
  };

  /// `multibody` must carry the parameters and preloads of `model`; both must outlive this object. Throws
  /// std::invalid_argument for steps that are not positive.
  FullSystem(Multibody& multibody, const CondensedModel& model, Steps steps);

  /// Throws SimulationError if the motion diverges, or cannot be found.
  void Run(const PostMotion& posts, double start, double step, const ReadingSink& sink,
           const std::function<bool()>& done) override;

  /// Evaluations of the full system in the last run.
  long evaluations() const { return evaluations_; }

 private:
  Multibody& multibody_;
  const CondensedModel& model_;
  Steps steps_;
  long evaluations_ = 0;
};

}  // namespace fourpost
