#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/text/diagnostics.h"
#include "vehicles/templates/hard_points.h"
#include "vehicles/templates/suspension_kind.h"

namespace fourpost {

/// One axle: its kind and all points that this needs.
struct AxlePoints {
  /// "front" or "rear".
  std::string axle;
  const SuspensionKind* kind = nullptr;
  std::map<std::string, HardPoint, std::less<>> points;

  bool Has(std::string_view point) const { return points.find(point) != points.end(); }
  const Eigen::Vector3d& At(std::string_view point) const { return points.find(point)->second.xyz; }
};

/// Of any car, from the front wheels' centres to the rear ones' [m].
inline constexpr double kLeastWheelbase = 0.5;

/// Front and rear.
using CarPoints = std::array<AxlePoints, 2>;

/// Kinds of both axles from "front=macpherson", "rear=twist_beam"; empty after a fault, of the option --suspension.
std::optional<std::array<const SuspensionKind*, 2>> ChosenSuspensions(const std::vector<std::string>& choices,
                                                                      Diagnostics& diagnostics);

/// The plausible points of these kinds.
std::vector<HardPoint> UsualPoints(const std::array<const SuspensionKind*, 2>& kinds);

/// The points of each axle. Reports all that the kinds miss, do not know or cannot use.
CarPoints SortedPoints(const std::array<const SuspensionKind*, 2>& kinds, const std::vector<HardPoint>& points,
                       const std::string& file, Diagnostics& diagnostics);

/// The file to edit: all points, in mm, with their meanings.
std::string PointsText(const CarPoints& car);

}  // namespace fourpost
