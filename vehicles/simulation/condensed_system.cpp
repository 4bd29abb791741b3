#include "vehicles/simulation/condensed_system.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/text/count_check.h"
#include "analysis/text/option_check.h"
#include "vehicles/multibody/simulation_error.h"
#include "vehicles/simulation/condensed_stepper.h"
#include "vehicles/simulation/findings.h"

namespace fourpost {
namespace {

/// Metres and metres per second that no vehicle on a rig comes to.
constexpr double kFarthest = 1e6;

}  // namespace

CondensedSystem::CondensedSystem(const CondensedModel& model, RigView rig, double longest_step_s)
    : TimeSystem(std::move(rig)), model_(model), longest_step_s_(longest_step_s) {
  RequireCount("CondensedSystem", "sensors of the model", static_cast<std::size_t>(model.on_position.rows()),
               this->rig().sensors.size());
  RequireCount("CondensedSystem", "posts of the model", static_cast<std::size_t>(model.post_stiffness.cols()),
               this->rig().post_count);
  RequireOption(longest_step_s > 0 && std::isfinite(longest_step_s), "CondensedSystem: longest_step_s", longest_step_s,
                "positive and finite");
}

void CondensedSystem::Run(const PostMotion& posts, double start, double step, const ReadingSink& sink,
                          const std::function<bool()>& done) {
  const long parts = std::max(1L, std::lround(std::ceil(step / longest_step_s_)));
  CondensedStepper stepper(model_, step / static_cast<double>(parts));
  std::vector<PostState> now(stepper.post_count());
  Eigen::VectorXd readings(stepper.sensor_count());
  posts(start, now);
  if (released().size() > 0) stepper.SetState(released(), now);
  else stepper.Start(now);
  for (long k = 0;; ++k) {
    const double t = start + static_cast<double>(k) * step;
    stepper.Read(readings);
    if (stepper.unsolved_steps() > 0) throw SimulationError(kForcesNotFound, {std::to_string(t) + " s"});
    // So written that it is true for NaN.
    if (!(stepper.state().norm() < kFarthest)) throw SimulationError(kMotionDiverges, {std::to_string(t) + " s"});
    sink(t, readings);
    if (done()) return;
    for (long part = 1; part <= parts; ++part) {
      posts(t + step * static_cast<double>(part) / static_cast<double>(parts), now);
      stepper.Step(now);
    }
  }
}

}  // namespace fourpost
