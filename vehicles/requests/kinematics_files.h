#pragma once

#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/poses/axle_kinematics.h"
#include "vehicles/ride/suspension.h"

namespace fourpost {

// Answers about the kinematics and compliance of a vehicle. `axles`: made of the same vehicle.

/// All stations, gradients and compliances, `findings` and versions; SI.
std::string KinematicsJson(const Vehicle& vehicle, const Suspension& suspension,
                           const std::vector<AxleKinematics>& axles, const Diagnostics& findings);

/// Comma-separated text, a row per axle, travel, position and wheel; mm, deg, N.
std::string WheelsCsv(const Suspension& suspension, const std::vector<AxleKinematics>& axles);

/// A row per axle, travel, position and strut: length in mm, motion ratio.
std::string RatiosCsv(const Suspension& suspension, const std::vector<AxleKinematics>& axles);

/// A row per axle, load, case and wheel: changes in deg and mm per kN, or per 100 N m of an aligning torque.
std::string ComplianceCsv(const Suspension& suspension, const std::vector<AxleKinematics>& axles);

/// One axle over its travels as an SVG picture.
std::string KinematicsSvg(const Vehicle& vehicle, const Suspension& suspension, const AxleKinematics& kinematics);

}  // namespace fourpost
