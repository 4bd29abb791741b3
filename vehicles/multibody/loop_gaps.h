#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Tenth of a millimetre, the accuracy of a drawing [m]: points written further apart are an error of the drawing.
constexpr double kDrawnGap_m = 1e-4;

/// A ball, weld or hinge whose two points do not coincide as written, in the pose where all joint coordinates are zero.
/// A rod keeps its distance there and is never open.
struct OpenClosure {
  /// Name in messages, with its mirror partner: "fp:ball 'joint_left' (and of 'joint_right')".
  std::string element;
  int source_line = 0;
  Point parent;
  Point child;
  /// As written [m].
  double gap = 0;
};

/// Closures with a gap above `least` [m], each pair of mirror partners once.
std::vector<OpenClosure> OpenClosures(const Vehicle& vehicle, double least);

/// An error for each loop closure that is open as written and cannot be closed; one at least. `distance`: of two points
/// [m] in the pose where an assembly gave up.
Diagnostics LoopGapFaults(const Vehicle& vehicle, const std::function<double(const Point&, const Point&)>& distance);

}  // namespace fourpost
