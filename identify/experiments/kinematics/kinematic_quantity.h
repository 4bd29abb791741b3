#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "analysis/text/units.h"
#include "vehicles/poses/axle_kinematics.h"

namespace fourpost {

/// What a kinematics and compliance rig measures, by the names of the columns that `fourpost kinematics` writes.
struct KinematicQuantity {
  /// Whose it is: "camber_left" is of a wheel, "track" of the axle, "motion_ratio_front_coil_left" of a strut.
  enum class Of { kWheel, kAxle, kStrut };
  std::string_view name;
  Of of = Of::kWheel;
  Dimension dimension;
  /// In which results show it.
  std::string_view unit;
  /// Whether a load on the wheels changes it, as their compliance.
  bool yields = false;
  /// SI; NaN where the vehicle has none. `of`: place in AxleStation::wheels, or of the strut in StrutsOf().
  double (*at_station)(const AxleStation& station, std::size_t of) = nullptr;
  /// Its change per N or N m, of one that yields.
  double (*per_load)(const WheelPlace& change) = nullptr;
  /// What it takes beyond the place of the wheels.
  StationWants wants = {.rates = false, .roll_centre = false};
};

std::span<const KinematicQuantity> KinematicQuantities();

/// Null for an unknown name.
const KinematicQuantity* FindKinematicQuantity(std::string_view name);

}  // namespace fourpost
