#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/diagnostics.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A drawing's tenth of a millimetre [m]: points that are written further apart are not meant to be where they are.
constexpr double kDrawnGap_m = 1e-4;

/// A ball, weld or hinge whose two points are apart as written: in the pose where all joint coordinates are zero. A rod
/// keeps the distance that it has there, so it is never open.
struct OpenClosure {
  /// As messages call it, with its twin of fp:mirror: "fp:ball 'joint_left' (and of 'joint_right')".
  std::string element;
  int source_line = 0;
  Point parent;
  Point child;
  /// As written [m].
  double gap = 0;
};

/// Those that are further open than `least` [m], a pair of twins once.
std::vector<OpenClosure> OpenClosures(const Vehicle& vehicle, double least);

/// An error for each loop closure that is open as written and cannot be closed; one at least. `distance`: of two points
/// [m] in the pose where an assembly gave up.
Diagnostics LoopGapFaults(const Vehicle& vehicle, const std::function<double(const Point&, const Point&)>& distance);

}  // namespace fourpost
