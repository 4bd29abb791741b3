#pragma once

#include "vehicles/multibody/multibody.h"
#include "vehicles/simulation/time_system.h"

namespace fourpost {

/// The full nonlinear multibody system in time, by Simbody's Runge-Kutta-Merson integrator.
class MultibodySystem : public TimeSystem {
 public:
  /// `accuracy`: relative, see Multibody::Integrate. The multibody system must outlive this object.
  MultibodySystem(Multibody& multibody, double accuracy);

  void Run(const PostMotion& posts, double start, double step, const ReadingSink& sink,
           const std::function<bool()>& done) override;

 private:
  Multibody& multibody_;
  double accuracy_;
};

}  // namespace fourpost
