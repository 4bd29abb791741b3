#include "identify/residuals/sensor_group.h"

#include <algorithm>

namespace fourpost {
namespace {

std::string LinkGroup(const Vehicle& vehicle, int link) {
  const bool has_tyre = std::any_of(vehicle.tyres.begin(), vehicle.tyres.end(),
                                    [&](const Tyre& tyre) { return tyre.point.link == link; });
  return has_tyre ? "wheels" : vehicle.links[static_cast<std::size_t>(link)].name;
}

}  // namespace

std::string SensorGroup(const Vehicle& vehicle, std::size_t sensor) {
  const Sensor& of = vehicle.sensors[sensor];
  switch (of.type) {
    case Sensor::Type::kLoadCell: return "tyre forces";
    case Sensor::Type::kStrut: return "struts";
    case Sensor::Type::kAccelerometer:
    case Sensor::Type::kDisplacement:
    case Sensor::Type::kGyro: return "motion of " + LinkGroup(vehicle, of.point.link);
  }
  return "";
}

}  // namespace fourpost
