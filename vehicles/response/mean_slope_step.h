#pragma once

#include <vector>

#include <Eigen/Core>

namespace fourpost {

class PortCycle;

/// Newton's method with the means of the slopes over the cycle in place of the slopes: with the effect G of forces on
/// extensions and the means a by extension, b by rate,
///   (I - G (a + i w b)) step = step of the plain iteration
/// at each harmonic w alone. Cheap for any number of harmonics; what it leaves out, the coupling of harmonics, Anderson
/// acceleration finds within few iterations. Ports with friction, knees, stops or lift take part: of others, whose
/// slopes scatter about the linear part, the means are small.
class MeanSlopeStep {
 public:
  /// With the slopes at the cycle's current iterate.
  explicit MeanSlopeStep(const PortCycle& cycle);

  /// `step`: of the plain iteration, (H + 1) x ports.
  Eigen::MatrixXcd Of(const Eigen::MatrixXcd& step) const;

 private:
  /// Ports that take part.
  std::vector<Eigen::Index> steep_;
  /// Per harmonic, ports x steep: what is added per step of these.
  std::vector<Eigen::MatrixXcd> answers_;
};

}  // namespace fourpost
