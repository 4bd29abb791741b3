#pragma once

#include <Eigen/Core>

namespace fourpost {

/// Directions are exact to rounding: projections leave about 1e-15 of them. A motion that nothing holds leaves a share
/// set by the geometry, centimetres in metres at the least.
inline constexpr double kHeldShare = 1e-9;

/// The preloads p that equilibrium sets: of all that hold a generalised force w, H p + w = 0, those of least strain
/// energy, sum of p_i^2 / (2 k_i). On a statically indeterminate car, springs and tyres thus share the load by their
/// rates k, as after lowering the unloaded car onto them: lateral load transfer follows roll stiffness.
///   p = p_0 - N (N' C N)^-1 N' C p_0,  p_0 = -H^+ w,  C = diag(1 / k),  N: preloads that balance each other, H N = 0.
class PreloadMap {
 public:
  PreloadMap() = default;
  /// `holders`: H, generalised force per unit of each preload, in columns; there may be none.
  explicit PreloadMap(const Eigen::MatrixXd& holders);

  /// Whether forces alone determine the preloads, for any rates.
  bool IsDeterminate() const { return redundant_.cols() == 0; }

  /// `rates`: not negative, one per preload; a preload without rate takes only what no other can.
  Eigen::VectorXd At(const Eigen::VectorXd& force, const Eigen::VectorXd& rates) const;

 private:
  /// -H^+.
  Eigen::MatrixXd least_;
  /// N, orthonormal.
  Eigen::MatrixXd redundant_;
};

}  // namespace fourpost
