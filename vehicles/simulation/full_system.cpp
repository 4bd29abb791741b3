#include "vehicles/simulation/full_system.h"

#include <cmath>
#include <string>

#include "analysis/text/option_check.h"
#include "vehicles/multibody/simulation_error.h"
#include "vehicles/simulation/findings.h"
#include "vehicles/simulation/full_stepper.h"

namespace fourpost {
namespace {

/// Metres and metres per second that no vehicle on a rig comes to.
constexpr double kFarthestPosition = 1e6;

long PartsOf(double whole, double longest) {
  // Rounding makes no part of its own.
  return std::max(1L, std::lround(std::ceil(whole / longest - 1e-9)));
}

/// Leaves the posts at rest, also after an exception.
struct PostsAtRestAfterwards {
  Multibody& multibody;
  ~PostsAtRestAfterwards() { multibody.SetPostMotion(nullptr); }
};

}  // namespace

FullSystem::FullSystem(Multibody& multibody, const CondensedModel& model, Steps steps)
    : TimeSystem(RigViewOf(multibody.vehicle())), multibody_(multibody), model_(model), steps_(steps) {
  for (const double step : {steps.longest_s, steps.longest_part_s})
    RequireOption(step > 0 && std::isfinite(step), "FullSystem: steps", step, "positive and finite");
}

void FullSystem::Run(const PostMotion& posts, double start, double step, const ReadingSink& sink,
                     const std::function<bool()>& done) {
  const long parts = PartsOf(step, steps_.longest_s);
  const double length = step / static_cast<double>(parts);
  FullStepper stepper(multibody_, model_, length, PartsOf(length, steps_.longest_part_s));
  const PostsAtRestAfterwards at_rest{multibody_};
  multibody_.SetPostMotion(posts);
  Eigen::VectorXd readings(static_cast<Eigen::Index>(rig().sensors.size()));
  stepper.Start(posts, start, released());
  for (long k = 0;; ++k) {
    const double t = start + static_cast<double>(k) * step;
    stepper.Read(readings);
    // So written that it is true for NaN.
    if (!(stepper.condensed().state().norm() < kFarthestPosition) || stepper.condensed().unsolved_steps() > 0)
      throw SimulationError(kMotionNotFound, {std::to_string(t) + " s"});
    sink(t, readings);
    evaluations_ = stepper.evaluations();
    if (done()) return;
    for (long part = 0; part < parts; ++part) stepper.Step(posts);
  }
}

}  // namespace fourpost
