#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "vehicles/bench/bench_motion.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A damper of a vehicle between the clamps of a bench, with whatever else acts between the same two points: its gas,
/// springs, stops, further dampers. Immutable; may be used from several threads at once.
class BenchDamper {
 public:
  /// `damper`: its place in Vehicle::dampers.
  BenchDamper(const Vehicle& vehicle, std::size_t damper);

  /// Tension [N] at the samples of a motion, with the laws that the multibody elements have, at these values of all
  /// parameters (SI). The preload of springs, and with it the static force of the gas in the design pose, is left out
  /// where the vehicle's equilibrium would decide on it. Series springs begin without force, hydraulic dampers at rest
  /// at mid-stroke. Empty where a chamber of a hydraulic damper closes. Throws std::invalid_argument for values that
  /// make no law.
  std::vector<double> Tensions(const BenchMotion& motion, std::span<const double> values) const;

  /// The same with half the steps of the motion and a tenth of the tolerance of series dampers.
  std::vector<double> FinerTensions(const BenchMotion& motion, std::span<const double> values) const;

  /// Distance of the points that it acts between, in the design pose [m]: no damper's stroke is as long as itself.
  double length_m() const { return length_m_; }

  /// The damper and those beside it.
  const std::vector<Damper>& dampers() const { return dampers_; }

  /// Whether springs or gas act beside it.
  bool HasSprings() const { return !springs_.empty(); }

 private:
  std::vector<double> Tensions(const BenchMotion& motion, std::span<const double> values, double tolerance) const;

  double length_m_ = 0;
  std::vector<Damper> dampers_;
  std::vector<Spring> springs_;
};

}  // namespace fourpost
