#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// A point of a suspension as a drawing lists it.
struct HardPoint {
  std::string axle;
  std::string name;
  /// x forward, y left, z up from the drawing's origin [m].
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();
  /// Part that carries it where that is not the usual one: "upper_arm".
  std::string on = {};
  /// 1-based; 0: of no file.
  int line = 0;
};

/// Reads a table with a header such as `axle,point,x [mm],y [mm],z [mm],on,note`, in any order; `on` and `note` may be
/// left out. Each coordinate has its unit; `-x [mm]` is a column that counts to the rear. Cells are separated by
/// commas, semicolons (numbers may have decimal commas then) or tabs; `#` begins a comment line. Reports all faults.
std::vector<HardPoint> ReadHardPoints(const std::filesystem::path& file, Diagnostics& diagnostics);

/// The same of a text, the content of `file`.
std::vector<HardPoint> HardPointsOf(std::string_view text, const std::string& file, Diagnostics& diagnostics);

}  // namespace fourpost
