#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// A vehicle as seen by a rig: its sensors, its posts, and reference sizes of motion.
struct RigView {
  /// In the order of the readings.
  std::vector<Sensor> sensors;
  std::size_t post_count = 0;
  /// Half the largest distance of two posts; 1 m for a lone one.
  double post_lever_m = 1;
  /// Of the stiffest tyre, unloaded [N/m].
  double tyre_stiffness = 0;
  std::size_t actuator_count = 0;
};

/// Of a vehicle at its file's values.
RigView RigViewOf(const Vehicle& vehicle);

/// Called with the time [s] and the sensor readings.
using ReadingSink = std::function<void(double t, const Eigen::VectorXd& readings)>;

/// A vehicle on its posts that can be integrated in time: the multibody system, or a reduced or closed-form model.
/// Interface for time integration to steady state and for time histories.
class TimeSystem {
 public:
  virtual ~TimeSystem() = default;
  TimeSystem(const TimeSystem&) = delete;
  TimeSystem& operator=(const TimeSystem&) = delete;

  const RigView& rig() const { return rig_; }

  /// Lets the vehicle go from this state of its reduced model, [s s' x], instead of rest in the design pose.
  void StartFrom(Eigen::VectorXd state) { released_ = std::move(state); }

  /// Runs from rest in the design pose, or from where it is let go, at `start`, reporting at start + k step for k = 0,
  /// 1, ... until `done`. Throws std::runtime_error if the motion cannot be computed.
  virtual void Run(const PostMotion& posts, double start, double step, const ReadingSink& sink,
                   const std::function<bool()>& done) = 0;

 protected:
  explicit TimeSystem(RigView rig) : rig_(std::move(rig)) {}
  /// Empty: from rest.
  const Eigen::VectorXd& released() const { return released_; }

 private:
  RigView rig_;
  Eigen::VectorXd released_;
};

}  // namespace fourpost
