#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "vehicles/bench/bench_motion.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A damper of a vehicle between the clamps of a bench, with all elements between the same two points: gas, springs,
/// stops, further dampers. Immutable; may be used from several threads at once.
class BenchDamper {
 public:
  /// `damper`: index in Vehicle::dampers.
  BenchDamper(const Vehicle& vehicle, std::size_t damper);

  /// Tension [N] at the samples of a motion, by the laws of the multibody elements, at these values of all parameters
  /// (SI). Excludes the preload of springs, and with it the static force of the gas in the design pose, where the
  /// vehicle's equilibrium would set it. Series springs start unloaded, hydraulic dampers at rest at mid-stroke. Empty
  /// if a chamber of a hydraulic damper closes. Throws std::invalid_argument for values that define no valid law.
  std::vector<double> Tensions(const BenchMotion& motion, std::span<const double> values) const;

  /// The same with half the steps of the motion and a tenth of the tolerance of series dampers.
  std::vector<double> FinerTensions(const BenchMotion& motion, std::span<const double> values) const;

  /// Distance of the damper's end points in the design pose [m], an upper bound of its stroke.
  double length_m() const { return length_m_; }

  /// The damper and those in parallel.
  const std::vector<Damper>& dampers() const { return dampers_; }

  /// Whether springs or gas act in parallel.
  bool HasSprings() const { return !springs_.empty(); }

 private:
  std::vector<double> Tensions(const BenchMotion& motion, std::span<const double> values, double tolerance) const;

  double length_m_ = 0;
  std::vector<Damper> dampers_;
  std::vector<Spring> springs_;
};

}  // namespace fourpost
