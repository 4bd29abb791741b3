#pragma once

#include <vector>

#include "vehicles/ride/named_modes.h"

namespace fourpost {

/// A mode of a vehicle and the motion of its bodies in it.
struct ShapedMode {
  Mode mode;
  std::vector<BodyShape> shape;
};

/// Of the vehicle at its values, which `model` has.
std::vector<ShapedMode> ShapedModes(const Vehicle& vehicle, const CondensedModel& model);

}  // namespace fourpost
