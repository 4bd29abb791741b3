#include "identify/residuals/calibrated_sensor.h"

#include <array>

namespace fourpost {
namespace {

// Those of sensors in the order of Sensor::Type.
constexpr std::array<std::string_view, 7> kGroups = {
    "accelerometers", "displacements", "struts", "load_cells", "gyros", Calibration::kPosts, Calibration::kStaticLoads};

}  // namespace

std::span<const std::string_view> CalibratedGroups() { return kGroups; }

bool IsOf(const Calibration& calibration, const Vehicle& vehicle, std::size_t sensor) {
  const Sensor& one = vehicle.sensors[sensor];
  return calibration.of == one.name || calibration.of == kGroups[static_cast<std::size_t>(one.type)];
}

}  // namespace fourpost
