#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "identify/study_file/calibration.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// What may be calibrated beside single sensors.
std::span<const std::string_view> CalibratedGroups();

/// Whether a calibration is of a sensor, by its name or its type. `sensor`: place in Vehicle::sensors.
bool IsOf(const Calibration& calibration, const Vehicle& vehicle, std::size_t sensor);

}  // namespace fourpost
