#include "vehicles/ride/shaped_modes.h"

#include <utility>

#include "vehicles/loops/design_kinematics.h"

namespace fourpost {

std::vector<ShapedMode> ShapedModes(const Vehicle& vehicle, const CondensedModel& model) {
  const std::vector<double> values = vehicle.ParameterValues();
  const Kinematics pose = DesignKinematics(vehicle);
  const Suspension suspension = SuspensionOf(vehicle, pose, values);
  std::vector<ShapedMode> shaped;
  for (Mode& mode : NamedModes(vehicle, pose, suspension, model, values)) {
    std::vector<BodyShape> shape = BodyShapes(suspension.bodies, mode);
    shaped.push_back({std::move(mode), std::move(shape)});
  }
  return shaped;
}

}  // namespace fourpost
