#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/curves/curve_file.h"

namespace fourpost {

/// A curve of a bench has some tens of points. All are law, and each costs time whenever it is computed.
inline constexpr std::size_t kMostCurvePoints = 1000;

/// How a curve is called in findings.
struct CurveNames {
  /// "extension", "speed".
  std::string x;
  /// The units in which points are shown.
  std::string x_unit;
  std::string force_unit = "N";
};

/// Turns falling points around. Reports fewer than two, more than a curve may have, and those that do not rise strictly
/// in both coordinates; false then.
bool OrderPoints(const std::string& file, const CurveNames& names, std::vector<CurvePoint>& points,
                 Diagnostics& diagnostics);

/// Of a damper: reports points whose force drives the motion, and a force at rest; false then.
bool CheckResistance(const std::string& file, const CurveNames& names, const std::vector<CurvePoint>& points,
                     Diagnostics& diagnostics);

}  // namespace fourpost
