#pragma once

#include <cstddef>
#include <vector>

#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/ride/suspension.h"

namespace fourpost {

/// A vehicle's chassis with one of its axles. While the chassis is held, the axle moves as on the whole vehicle, for
/// the cube of a fraction of the work.
struct OneAxle {
  Vehicle vehicle;
  /// Places in the whole vehicle of what is left.
  std::vector<std::size_t> springs;
  std::vector<std::size_t> bushings;

  /// Those of the whole vehicle for this one; tyres, on which the rig's pads push, carry nothing.
  Preloads PreloadsOf(const Preloads& whole) const;
};

/// `suspension`: of the vehicle. Parts that elements or closures join to the axle stay, posts, sensors and actuators
/// go. All of the vehicle stays where it has no chassis.
OneAxle OneAxleOf(const Vehicle& vehicle, const Suspension& suspension, std::size_t axle);

}  // namespace fourpost
