#pragma once

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/simulation/time_system.h"

namespace fourpost {

/// A reduced or closed-form model in time, by CondensedStepper.
class CondensedSystem : public TimeSystem {
 public:
  /// Steps are whole parts of Run()'s output step, none longer than `longest_step_s`. The sensors are those whose rows
  /// the model has. The model must outlive this object. Throws std::invalid_argument for other numbers of sensors or
  /// posts than the model's, and for a step that is not positive.
  CondensedSystem(const CondensedModel& model, RigView rig, double longest_step_s = 5e-4);

  /// Throws std::runtime_error if the motion diverges, or if the forces of its elements cannot be found.
  void Run(const PostMotion& posts, double start, double step, const ReadingSink& sink,
           const std::function<bool()>& done) override;

 private:
  const CondensedModel& model_;
  double longest_step_s_;
};

}  // namespace fourpost
