#include "vehicles/simulation/multibody_system.h"

#include "vehicles/multibody/simulation_error.h"
#include "vehicles/simulation/findings.h"

namespace fourpost {

MultibodySystem::MultibodySystem(Multibody& multibody, double accuracy)
    : TimeSystem(RigViewOf(multibody.vehicle())), multibody_(multibody), accuracy_(accuracy) {}

void MultibodySystem::Run(const PostMotion& posts, double start, double step, const ReadingSink& sink,
                          const std::function<bool()>& done) {
  if (released().size() > 0) throw SimulationError(kReleaseOfMultibody);
  multibody_.SetPostMotion(posts);
  multibody_.Integrate(
      multibody_.RestState(), start, step, accuracy_,
      [&](double t, const Eigen::VectorXd&, const Eigen::VectorXd& readings) { sink(t, readings); }, done);
  multibody_.SetPostMotion(nullptr);
}

}  // namespace fourpost
