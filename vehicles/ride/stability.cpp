#include "vehicles/ride/stability.h"

#include <cmath>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "analysis/text/number.h"
#include "vehicles/loops/design_kinematics.h"
#include "vehicles/ride/named_modes.h"

namespace fourpost {

std::string Growth::Text() const {
  return modes + (is_one ? " grows" : " grow") + " by exp(" + FormatNumber(std::round(1e3 * rate_per_s) / 1e3) + " t)";
}

std::optional<Growth> GrowthOf(const std::vector<Mode>& modes, double growth_rate) {
  if (growth_rate < kSlowestMotion_per_s) return std::nullopt;
  Growth growth{.rate_per_s = growth_rate};
  for (const Mode& mode : modes)
    if (mode.pole.real() >= kSlowestMotion_per_s) {
      growth.is_one = growth.modes.empty();
      growth.modes += (growth.is_one ? "'" : " and '") + mode.name + "'";
    }
  if (growth.modes.empty()) growth.modes = "a motion";
  return growth;
}

std::optional<Growth> GrowthOf(const Vehicle& vehicle, const CondensedModel& model) {
  const double growth_rate = EigenvaluesOf(StateMatrix(model)).real().maxCoeff();
  if (growth_rate < kSlowestMotion_per_s) return std::nullopt;
  const std::vector<double> values = vehicle.ParameterValues();
  const Kinematics pose = DesignKinematics(vehicle);
  return GrowthOf(NamedModes(vehicle, pose, SuspensionOf(vehicle, pose, values), model, values), growth_rate);
}

}  // namespace fourpost
