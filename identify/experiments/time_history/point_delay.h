#pragma once

#include <cstddef>
#include <vector>

#include "identify/experiments/time_history/history_data.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A displacement that comes later than the acceleration of the same point, or earlier: signals of a history.
struct PointDelay {
  std::size_t displacement = 0;
  std::size_t acceleration = 0;
  /// Above zero: the displacement is late.
  double delay_s = 0;
};

/// Those of more than a sample, found without any model: over h the second difference of a displacement z and the
/// acceleration a under a triangle of half-width h are the same,
///   (z(t+h) - 2 z(t) + z(t-h)) / h^2 = integral of a(t+s) (1 - |s|/h) ds / h,
/// which a delay alone keeps apart. Pairs are a displacement sensor and a vertical accelerometer at one point.
std::vector<PointDelay> PointDelays(const Vehicle& vehicle, const MeasuredHistory& history);

}  // namespace fourpost
