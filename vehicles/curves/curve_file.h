#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// A point of a measured curve in SI, as vehicle files count: extension, its speed and tension positive.
struct CurvePoint {
  /// Extension [m] of a spring, speed [m/s] of a damper, deflection [m] of a tyre, whose force pushes.
  double x = 0;
  double force = 0;
  int line = 0;
};

/// Of a file: increasing in both coordinates.
struct SpringCurve {
  std::vector<CurvePoint> points;
  /// Where the points count from the free length and the file states it [m].
  std::optional<double> free_length;
};

/// Rates along and about x, y, z [N/m, N m/rad, N s/m, N m s/rad].
struct BushingRates {
  std::array<double, 6> stiffness = {};
  std::array<double, 6> damping = {};
};

// A file is a table of text or of a measurement system with columns `extension`, `speed` or `deflection`, and `force`,
// or an Adams property file in TeimOrbit format, of 1 MiB at most. All faults are reported with their lines, up to 100;
// nothing is returned when there was one.

/// Property files (.spr): the block [CURVE] holds the deflection from FREE_LENGTH of [SPRING_DATA], shortening
/// positive, and the force, push positive: force = curve(FREE_LENGTH - length). Both signs change.
/// Source: Adams Car Package, "Use Hardpoints"; Altair MotionView, AutoSpring, "Sign Convention".
std::optional<SpringCurve> ReadSpringCurve(const std::filesystem::path& file, Diagnostics& diagnostics);

/// Property files (.dpr): the block [CURVE] holds the speed at which the ends part, extension positive, and the force
/// that resists it, of the same sign; neither changes. The law adds (0, 0) where the points leave it out.
std::optional<std::vector<CurvePoint>> ReadDamperCurve(const std::filesystem::path& file, Diagnostics& diagnostics);

/// Property files (.tir): the block [DEFLECTION_LOAD_CURVE] holds penetration and vertical force.
/// Source: Adams Tire, "Using the PAC2002 Tire Model".
std::optional<std::vector<CurvePoint>> ReadTyreCurve(const std::filesystem::path& file, Diagnostics& diagnostics);

/// Property files (.bus) only: blocks [FX_CURVE] to [TZ_CURVE] with displacement or angle and the force or torque that
/// resists it, and constants FX_DAMPING to TZ_DAMPING of [DAMPING], none where that block is missing. A stiffness is
/// the slope between the points next to zero on both sides; a curve whose mean rate differs from it is warned of.
std::optional<BushingRates> ReadBushingRates(const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace fourpost
