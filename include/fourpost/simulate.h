#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <fourpost/response.h>
#include <fourpost/vehicle.h>

namespace fourpost::api {

/// Heights of posts over time [m], upward from the position under the resting vehicle, equally many samples each. Posts
/// that are not named stand still.
struct PostHeights {
  double rate_Hz = 0;
  std::map<std::string, Eigen::VectorXd> height_m;
  /// Of posts without a stroke in the vehicle file, from end to end [m].
  double stroke_m = 0.15;
};

struct History {
  double rate_Hz = 0;
  /// Readings by the name of their sensor, in its SI unit and with the sign and the zero that its tag in urdf/README.md
  /// states; sample k is at k / rate_Hz.
  std::map<std::string, Eigen::VectorXd> readings;
  /// The one that answered: kReduced or kFull.
  Engine engine = Engine::kReduced;
  /// Largest change of a channel by the last halving of the step, over its rms; the error left is about a third.
  std::optional<double> step_change;
  /// Largest error of linear kinematics over a channel's rms, as far as kAuto could estimate it.
  std::optional<double> kinematics_error;
};

/// A vehicle from rest over moving posts, between whose samples a spline goes. Engines are those of
/// Respond() but kTimeIntegration, which is refused: kFull integrates in time here. Throws Error as Respond() does.
/// `stop`: asked often, from the calling thread; true ends the history there.
History Simulate(const Vehicle& vehicle, const PostHeights& posts, Engine engine = Engine::kAuto,
                 const std::function<bool()>& stop = {});

}  // namespace fourpost::api
